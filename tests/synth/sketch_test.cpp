#include "synth/sketch/sketch.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "field/error.h"
#include "field/files.h"
#include "field/noise.h"
#include "field/packaged.h"
#include "synth/sketch/bands.h"
#include "synth/sketch/boundary.h"
#include "synth/sketch/sight.h"
#include "synth/sketch/stroke.h"

namespace cydonia::sketch {
namespace {

namespace fs = std::filesystem;

struct Said final : Progress {
    std::string notes;
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view sentence) override { notes += sentence; }
    void warn(std::string_view sentence) override { notes += sentence; }
};

class Sketch : public testing::Test {
  protected:
    Sketch() { fs::create_directories(folder_); }
    ~Sketch() override { fs::remove_all(folder_); }

    // Paths on a page of 100 x 100.
    Source drawing(const std::string& paths) {
        const fs::path file = folder_ / (std::to_string(drawings_++) + ".svg");
        write_text(file,
                   "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' "
                   "width='100' height='100'>" +
                       paths + "</svg>");
        return open_source(file);
    }
    Silhouette stroke(const std::string& paths) {
        return {drawing(paths), "", 0.0, 1000.0, false};
    }
    Terrain made(const Options& options) {
        Terrain terrain;
        terrain.spacing = 10.0;
        NoiseOptions noise;
        noise.octaves = 6;
        noise.h = 1.0;
        terrain.heights = noise_field(noise, 200, 160, 50.0, 3);
        before_ = terrain.heights;
        Context context;
        context.seed = 4;
        context.progress = &said_;
        context.memory = memory_.next.empty() ? nullptr : &memory_;
        return run(options, terrain, context);
    }
    // Looking north over the land from its south, the horizon in the middle of the page.
    View view(const std::string& paths, const std::string& camera = kCamera) {
        return {drawing("<metadata>" + camera + "</metadata>" + paths), "", false, {}};
    }
    static constexpr const char* kCamera =
        "<camera xmlns='urn:cydonia' eye='1000 -2000 300' target='1000 0 300' "
        "field-of-view='40'/>";
    Feature seen(const std::string& paths) {
        Feature feature;
        feature.name = "skyline";
        feature.view = view(paths);
        return feature;
    }
    std::string complaint(const Options& options) {
        try {
            made(options);
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadRequest);
            return error.what();
        }
    }
    static float highest(const Terrain& terrain) {
        return *std::ranges::max_element(terrain.heights);
    }
    static Feature feature(double height) {
        Feature feature;
        feature.name = "ridge";
        feature.way.points = {{metres(300.0), metres(800.0)},
                              {metres(1000.0), metres(1000.0)},
                              {metres(1700.0), metres(700.0)}};
        feature.height = height;
        return feature;
    }

    Said said_;
    Memory memory_;
    Field<float> before_;
    fs::path folder_ =
        fs::temp_directory_path() / ("cydonia_sketch_" + std::to_string(getpid()));
    int drawings_ = 0;
};

TEST_F(Sketch, SilhouettesAreReadFromLeftToRight) {
    const Field<float> heights = heights_of(
        stroke("<path d='M20 90 L60 10 L80 50' fill='none'/>"), 61, "a", said_);
    EXPECT_NEAR(heights[0], 100.0, 0.1);
    EXPECT_NEAR(heights[20], 500.0, 0.1);  // halfway to the top
    EXPECT_NEAR(heights[40], 900.0, 0.1);
    EXPECT_NEAR(heights[60], 500.0, 0.1);
    EXPECT_EQ(said_.notes, "");
}

TEST_F(Sketch, LaterStrokesReplaceWhatTheyRetrace) {
    const Field<float> heights = heights_of(
        stroke("<path d='M0 80 L100 80'/><path d='M40 20 L60 20'/>"), 101, "a", said_);
    EXPECT_NEAR(heights[20], 200.0, 0.1);
    EXPECT_NEAR(heights[50], 800.0, 0.1);
    EXPECT_NEAR(heights[80], 200.0, 0.1);
}

TEST_F(Sketch, FoldsAreRepairedAndSaid) {
    const Field<float> heights = heights_of(
        stroke("<path d='M0 80 L60 80 L40 30 L100 30' fill='none'/>"), 101, "a", said_);
    EXPECT_NEAR(heights[30], 200.0, 0.1);
    EXPECT_NEAR(heights[50], 700.0, 0.1);
    EXPECT_NE(said_.notes.find("folds back"), std::string::npos);
}

TEST_F(Sketch, StrokesThatSayNothingAreRefused) {
    EXPECT_THROW(heights_of(stroke(""), 10, "a", said_), Error);
    EXPECT_THROW(heights_of(stroke("<path d='M50 0 L50 90'/>"), 10, "a", said_), Error);
    Silhouette other = stroke("<path id='b' d='M0 0 L50 90'/>");
    other.id = "c";
    EXPECT_THROW(heights_of(other, 10, "a", said_), Error);
}

TEST_F(Sketch, FiguresSayHowFarTheLandIsFromTheStroke) {
    Options options;
    options.features = {feature(0.0)};
    options.features[0].silhouette =
        stroke("<path d='M0 100 L25 60 L35 75 L50 40 L70 55 L100 100' fill='none'/>");
    const Terrain terrain = made(options);
    const double off = terrain.figures.at("sketch: 'ridge' off its silhouette, most, m");
    EXPECT_GT(highest(terrain), 560.0f);
    EXPECT_LT(off, 0.005 * 600.0);
}

TEST_F(Sketch, LaterLandformsStandOnThoseBefore) {
    Options options;
    options.features = {feature(300.0), feature(100.0)};
    options.features[1].name = "on top";
    const float both = highest(made(options));
    options.features.pop_back();
    const float one = highest(made(options));
    EXPECT_NEAR(both - one, 100.0, 20.0);
}

TEST_F(Sketch, BoundariesAreHeldAlongTheWay) {
    Options options;
    options.features = {feature(300.0)};
    options.features[0].holds = {{0.0, {}, {{metres(100.0), metres(100.0)}}},
                                 {1.0, {}, {{metres(100.0), metres(100.0)}}}};
    const Field<float> narrow = made(options).heights;
    options.features[0].holds.clear();
    const Field<float> plain = made(options).heights;
    const auto changed = [&](const Field<float>& land) {
        int count = 0;
        for (std::size_t i = 0; i < land.size(); ++i) count += land[i] != before_[i];
        return count;
    };
    // 100 m, and half of 300 m at 30 degrees: 260 m.
    EXPECT_NEAR(double(changed(plain)) / changed(narrow), 2.6, 0.4);
}

TEST_F(Sketch, RegionsChangeFineScalesInsideTheirLoop) {
    Options options;
    RoughRegion region;
    region.name = "moor";
    region.way.points = {{metres(500.0), metres(300.0)},
                         {metres(1500.0), metres(300.0)},
                         {metres(1500.0), metres(1300.0)},
                         {metres(500.0), metres(1300.0)},
                         {metres(500.0), metres(300.0)}};
    std::string path = "M0 50";
    for (int i = 1; i <= 200; ++i)
        path += fmt::format(" L{} {}", 0.5 * i, i % 2 ? 48 : 52);
    region.noise = stroke("<path d='" + path + "' fill='none'/>");
    options.regions = {region};
    const Terrain terrain = made(options);
    const auto scales = smoothed(terrain.heights, 6), old = smoothed(before_, 6);
    double coarse = 0.0, fine = 0.0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 200; ++x) {
            // The loop is smooth through its points, and bulges between them.
            const bool outside = x < 25 || x > 175 || y < 5 || y > 155;
            if (outside) {
                ASSERT_EQ(terrain.heights(x, y), before_(x, y)) << x << ", " << y;
            }
            coarse = std::max(coarse, std::abs(double(scales[1](x, y)) - old[1](x, y)));
            fine =
                std::max(fine, std::abs(double(terrain.heights(x, y)) - before_(x, y)));
        }
    EXPECT_GT(fine, 10.0);
    EXPECT_LT(coarse, 0.1 * fine);
}

TEST_F(Sketch, CurvesThatSayNothingAreRefused) {
    Options options;
    options.features = {feature(300.0)};
    options.features[0].way.points = {{metres(5.0), metres(5.0)},
                                      {metres(5.0), metres(5.0)}};
    EXPECT_NE(complaint(options).find("no length"), std::string::npos);
    options.features[0].way = {{}, drawing("<path id='a' d='M0 0 L9 9'/>"), "b"};
    EXPECT_NE(complaint(options).find("no path has the id 'b'"), std::string::npos);
}

const char* const kStroke = "<path d='M30 65 L45 40 L55 46 L70 66' fill='none'/>";

// A level land seen from 2000 m before it: pixels of the page are known tangents.
TEST_F(Sketch, LinesOfSightAreThoseOfTheCamera) {
    const Sight sight(view("<path d='M25 40 L75 40' fill='none'/>"), "a", said_);
    const double half = std::tan(0.5 * 40.0 * M_PI / 180.0);
    // A tenth of the page's width above the horizon, wherever it stands.
    for (const double east : {700.0, 1000.0, 1300.0})
        EXPECT_NEAR(*sight.height_over({east, 1000.0}), 300.0 + 0.2 * half * 3000.0, 0.1);
    EXPECT_NEAR(*sight.height_over({1000.0, 2000.0}), 300.0 + 0.2 * half * 4000.0, 0.1);
    EXPECT_FALSE(sight.height_over({1000.0 + 0.51 * half * 3000.0, 1000.0}));
    EXPECT_TRUE(sight.height_over({1000.0 + 0.49 * half * 3000.0, 1000.0}));
    EXPECT_FALSE(sight.height_over({1000.0, -3000.0}));
}

TEST_F(Sketch, StrokesInAViewEndWhereTheyMeetTheLand) {
    const Sight sight(view(kStroke), "a", said_);
    const Field<float> flat(200, 160);
    const auto landing = landing_of(flat, 10.0, sight.eye(), 300.0, sight.ends()[0]);
    ASSERT_TRUE(landing);
    EXPECT_FALSE(landing->on_wall);
    // 15 hundredths of the page below the horizon: 300 m down over this distance ahead.
    const double half = std::tan(0.5 * 40.0 * M_PI / 180.0);
    EXPECT_NEAR(landing->place[1] + 2000.0, 300.0 / (0.3 * half), 1.0);
    EXPECT_TRUE(landing_of(flat, 10.0, sight.eye(), 900.0, sight.ends()[0])->on_wall);
    EXPECT_FALSE(landing_of(flat, 10.0, {-9000.0, -9000.0}, 900.0, sight.ends()[0]));
}

TEST_F(Sketch, TheStrokeIsTheSkyline) {
    Options options;
    options.features = {seen(kStroke)};
    const Terrain terrain = made(options);
    EXPECT_LT(terrain.figures.at(
                  "sketch: 'skyline' off its stroke in the view, on average, px"),
              0.5);
    EXPECT_LT(terrain.figures.at("sketch: 'skyline' off its silhouette, most, m"), 4.0);
    EXPECT_GT(highest(terrain), *std::ranges::max_element(before_) + 200.0f);
}

// What rises gently behind the crest would be seen above it.
TEST_F(Sketch, NothingOfALandformIsSeenAboveItsStroke) {
    Options options;
    options.features = {seen(kStroke)};
    options.features[0].view->drawing =
        view(kStroke,
             "<camera xmlns='urn:cydonia' eye='1000 -1500 1600' "
             "target='1000 600 100' field-of-view='40'/>")
            .drawing;
    options.features[0].boundary = {{metres(700.0), metres(300.0)}};
    const Terrain terrain = made(options);
    EXPECT_LT(terrain.figures.at(
                  "sketch: 'skyline' off its stroke in the view, on average, px"),
              1.0);
}

// Led over the land by a way of its own, the silhouette bends with it and is seen the
// same.
TEST_F(Sketch, SilhouettesFollowABentWay) {
    Options options;
    options.features = {seen(kStroke)};
    options.features[0].way.points = {{metres(300.0), metres(1100.0)},
                                      {metres(1000.0), metres(600.0)},
                                      {metres(1800.0), metres(1200.0)}};
    const Terrain terrain = made(options);
    EXPECT_LT(terrain.figures.at(
                  "sketch: 'skyline' off its stroke in the view, on average, px"),
              1.0);
    EXPECT_NE(said_.notes.find("ends where its stroke does"), std::string::npos);
    EXPECT_GT(terrain.heights(100, 160 - 60), before_(100, 160 - 60) + 100.0f);
}

TEST_F(Sketch, StrokesThreadBehindLandforms) {
    Options options;
    Feature hill = feature(200.0);
    hill.name = "hill";
    hill.boundary = {{metres(100.0), metres(100.0)}};
    hill.way.points = {{metres(200.0), metres(300.0)}, {metres(1800.0), metres(300.0)}};
    options.features = {hill, seen(kStroke)};
    made(options);
    EXPECT_NE(said_.notes.find("'skyline' ends on 'hill'"), std::string::npos)
        << said_.notes;
    said_.notes.clear();
    options.features[1].view->through = {"hill"};
    const Terrain through = made(options);
    EXPECT_EQ(said_.notes.find("ends on"), std::string::npos) << said_.notes;
    EXPECT_LT(through.figures.at(
                  "sketch: 'skyline' off its stroke in the view, on average, px"),
              1.0);
}

TEST_F(Sketch, ViewsThatShowNothingAreRefused) {
    const auto refused = [&](const std::string& paths, const std::string& camera) {
        Options options;
        options.features = {seen(paths)};
        options.features[0].view = view(paths, camera);
        return complaint(options);
    };
    EXPECT_NE(refused(kStroke, "").find("names no camera"), std::string::npos);
    EXPECT_NE(refused("<path d='M150 10 L180 60'/>", kCamera).find("outside the frame"),
              std::string::npos);
    EXPECT_NE(refused("<path d='M50 50'/>", kCamera).find("nothing is drawn"),
              std::string::npos);
    EXPECT_NE(refused("<path d='M50 10 L50 60'/>", kCamera).find("upright"),
              std::string::npos);
    EXPECT_NE(refused(kStroke,
                      "<camera xmlns='urn:cydonia' eye='9000 -2000 300' "
                      "target='9000 0 300' field-of-view='40'/>")
                  .find("beside the terrain"),
              std::string::npos);
    EXPECT_NE(refused(kStroke,
                      "<camera xmlns='urn:cydonia' eye='1 2' target='1 2 3' "
                      "field-of-view='40'/>")
                  .find("three numbers"),
              std::string::npos);
    EXPECT_NE(refused(kStroke,
                      "<camera xmlns='urn:cydonia' eye='1 2 9' target='1 2 3' "
                      "field-of-view='40'/>")
                  .find("straight up or down"),
              std::string::npos);
}

// Strokes from strangers end in time.
TEST_F(Sketch, StrokesFarBeyondTheFrameTakeNoLonger) {
    Options options;
    options.features = {seen("<path d='M-900000 65 L45 40 L55 46 L900000 66'/>")};
    options.features[0].way.points = {{metres(100.0), metres(800.0)},
                                      {metres(1900.0), metres(900.0)}};
    made(options);
    std::string many;
    for (int i = 0; i < 300; ++i) many += fmt::format("<path d='M{} 10 V90'/>", i % 97);
    options.features = {feature(100.0)};
    options.features[0].way = {{}, drawing(many), ""};
    EXPECT_NE(complaint(options).find("300 paths are too many"), std::string::npos);
}

// Figure 3: one peak stands on a disc, a range of short shoulders on a long capsule.
TEST_F(Sketch, DefaultBoundariesAreCapsules) {
    Field<float> peak(201, 1), range(201, 1);
    for (int i = 0; i < 201; ++i) {
        peak[std::size_t(i)] = 100.0f - float(std::abs(i - 100));
        range[std::size_t(i)] =
            std::min({100.0f, 5.0f * float(i), 5.0f * float(200 - i)});
    }
    const Boundary disc = capsule(peak, 2000.0), narrow = capsule(range, 2000.0);
    EXPECT_NEAR(disc(1000.0)[0], 1000.0, 150.0);
    EXPECT_NEAR(disc(200.0)[0], 600.0, 120.0);  // of the circle
    EXPECT_NEAR(narrow(1000.0)[1], 250.0, 120.0);
    EXPECT_NEAR(narrow(600.0)[1], narrow(1000.0)[1], 1.0);
    EXPECT_LT(narrow(0.0)[0], 1.0);
}

TEST_F(Sketch, BoundariesAreDrawn) {
    Options options;
    options.features = {feature(300.0)};
    // North near, south far; the page is 2000 m wide and 1600 m deep.
    options.features[0].boundary_curve = Way{
        {}, drawing("<path d='M5 35 L50 30 L95 45 L95 90 L5 90 Z' fill='none'/>"), ""};
    const Terrain terrain = made(options);
    const auto changed = [&](int x, int y) {
        return terrain.heights(x, y) != before_(x, y);
    };
    EXPECT_TRUE(changed(100, 160 - 104));
    EXPECT_FALSE(changed(100, 160 - 115));  // 70 % of the depth is 1120 m
    EXPECT_TRUE(changed(100, 160 - 30));

    options.features[0].boundary_curve->drawing = drawing("<path d='M5 90 L95 90'/>");
    EXPECT_NE(complaint(options).find("does not surround"), std::string::npos);
    said_.notes.clear();
    options.features[0].boundary_curve->drawing =
        drawing("<path d='M5 90 L95 90'/><path d='M5 30 L30 30 L30 70 L60 20 L95 20'/>");
    made(options);
    EXPECT_NE(said_.notes.find("crosses its way"), std::string::npos) << said_.notes;
}

TEST_F(Sketch, LoopsOfAWayAreCutOff) {
    std::vector<Point2> way = {{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, -5}};
    EXPECT_EQ(cut_loops(way), 1);
    EXPECT_EQ(way, (std::vector<Point2>{{0, 0}, {5, 0}, {5, -5}}));
    // Of a ring the larger part stays.
    std::vector<Point2> ring = {{0, 0},   {100, 0}, {100, 100}, {0, 100}, {0, 10},
                                {-5, 10}, {-5, 5},  {5, 5},     {0, 0}};
    cut_loops(ring);
    double area = 0.0;
    for (std::size_t i = 1; i < ring.size(); ++i)
        area += 0.5 * geometry::cross(ring[i - 1], ring[i]);
    EXPECT_NEAR(std::abs(area), 1e4, 200.0);
    Options options;
    options.features = {feature(300.0)};
    options.features[0].way = {
        {}, drawing("<path d='M10 50 L60 50 L60 30 L50 30 L50 60 L90 60'/>"), ""};
    made(options);
    EXPECT_NE(said_.notes.find("crosses itself"), std::string::npos);
}

TEST_F(Sketch, BranchesOfADrawingAreOneFeature) {
    Options options;
    options.features = {feature(300.0)};
    options.features[0].way = {
        {}, drawing("<g id='b'><path d='M10 50 H90'/><path d='M50 50 V90'/></g>"), "b"};
    const Terrain terrain = made(options);
    // 300 m above the land under both, not 600 where they meet.
    const float junction = terrain.heights(100, 80) - before_(100, 80);
    EXPECT_NEAR(junction, 300.0f, 40.0f);
    EXPECT_NEAR(terrain.heights(100, 110) - before_(100, 110), 300.0f, 60.0f);
}

// One landform more or less leaves the others as they are.
TEST_F(Sketch, LandformsAreSeededByTheirNames) {
    Options options;
    Feature west = feature(200.0), east = feature(200.0);
    west.name = "west", east.name = "east";
    west.way.points = {{metres(200.0), metres(300.0)}, {metres(500.0), metres(900.0)}};
    east.way.points = {{metres(1400.0), metres(300.0)}, {metres(1700.0), metres(900.0)}};
    for (Feature* side : {&west, &east}) {
        std::string path = "M0 60";
        for (int i = 1; i <= 40; ++i)
            path += fmt::format(" L{} {}", 2.5 * i, 60.0 + 10.0 * std::sin(i * i));
        side->silhouette = stroke("<path d='" + path + "' fill='none'/>");
        side->silhouette->top = 300.0;
    }
    options.features = {west, east};
    const Field<float> both = made(options).heights;
    options.features = {east};
    const Field<float> one = made(options).heights;
    // The widest scales reach a little way; another seed would be metres off.
    for (int y = 0; y < 160; ++y)
        for (int x = 110; x < 200; ++x)
            ASSERT_NEAR(both(x, y), one(x, y), 2.0) << x << ' ' << y;
}

TEST_F(Sketch, WhatStoodOnAMissingLandformIsNamed) {
    Options options;
    Feature range = feature(300.0), tower = feature(100.0);
    range.name = "range", tower.name = "tower";
    options.features = {range, tower};
    memory_.next = folder_ / "next";
    made(options);
    memory_ = {folder_ / "next", folder_ / "then"};
    options.features = {tower};
    made(options);
    EXPECT_NE(said_.notes.find("'range' is gone"), std::string::npos) << said_.notes;
    EXPECT_NE(said_.notes.find("'tower'"), std::string::npos) << said_.notes;
    said_.notes.clear();
    write_text(folder_ / "damaged", "cydonia sketch 1\n\t\t\n\x01\x02");
    memory_.last = folder_ / "damaged";
    made(options);
    EXPECT_EQ(said_.notes, "");
}

// Bands of real land, as strong as the silhouette has them.
TEST_F(Sketch, NoiseIsOfRealLand) {
    if (packaged_dems().empty()) GTEST_SKIP() << "no packaged elevation model";
    Options options;
    options.features = {feature(100.0)};
    std::string path = "M0 50";
    for (int i = 1; i <= 60; ++i)
        path += fmt::format(" L{} {}", i / 0.6, 50.0 + 4.0 * std::sin(i * i));
    options.features[0].silhouette = stroke("<path d='" + path + "' fill='none'/>");
    options.features[0].silhouette->top = 200.0;
    const Field<float> plain = made(options).heights;
    try {
        options.noise_from = open_packaged_dem("jacksboro");
    } catch (const Error& error) {
        GTEST_SKIP() << error.what();
    }
    for (const NoiseKind kind :
         {NoiseKind::kWavelet, NoiseKind::kTexture, NoiseKind::kDetail}) {
        options.noise = kind;
        const Terrain terrain = made(options);
        EXPECT_FALSE(std::ranges::equal(terrain.heights, plain)) << int(kind);
        EXPECT_LT(terrain.figures.at("sketch: 'ridge' off its silhouette, most, m"), 4.0)
            << int(kind);
        for (int x = 0; x < 200; ++x) ASSERT_EQ(terrain.heights(x, 5), before_(x, 5));
    }
}

}  // namespace
}  // namespace cydonia::sketch
