#include "synth/sketch/sketch.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "field/error.h"
#include "field/files.h"
#include "field/noise.h"
#include "synth/sketch/bands.h"
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
        return run(options, terrain, context);
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
    Region region;
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

}  // namespace
}  // namespace cydonia::sketch
