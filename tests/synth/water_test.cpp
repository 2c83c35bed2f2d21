#include "synth/distance/water.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "tests/synth/distance_land.h"

namespace cydonia::distance {
namespace {

constexpr double kExtent = 1280.0;

// Dark where wet(east, north), shares of the width.
template <class Wet>
Field<Rgb8> drawing(const Wet& wet, int side = 256) {
    Field<Rgb8> pixels(side, side, kWhite);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            if (wet((x + 0.5) / side, (side - y - 0.5) / side)) pixels(x, y) = kBlack;
    return pixels;
}

bool in_the_east(double east, double) { return east > 0.5; }
bool in_the_middle(double east, double north) {
    return std::hypot(east - 0.5, north - 0.5) < 0.2;
}

// 40 m deep at the foot of a straight bed 200 m long, on weights without chance.
Options water(const Source& image, double level = 0.0) {
    Options options;
    options.edge_weight_deviation = 0.0;
    options.neighbours = 16;
    Profile bed;
    bed.name = "bed";
    bed.curve.points = {{0, 1}, {1, 0}};
    bed.reach = metres(200.0);
    options.profiles = {bed};
    Water water{image};
    water.level = metres(level);
    water.depth = metres(40.0);
    water.bed = "bed";
    options.water = {water};
    return options;
}

Terrain level_land(float height, int side = 128) {
    Terrain terrain = flat(side, side, kExtent);
    for (float& h : terrain.heights) h = height;
    return terrain;
}

Terrain laid(const Options& options, Terrain terrain) {
    const Graph graph = graph_of(terrain.heights.width(), terrain.heights.height(),
                                 terrain.spacing, edges_of(options, terrain.width()), 1);
    lay_water(terrain, options, graph);
    return terrain;
}

// The metres from the west at which the land crosses the level, between the first wet
// sample of a row and the one west of it.
double shore_in_row(const Terrain& terrain, int y, float level) {
    int x = 1;
    while (water_depth(terrain, terrain.heights.index(x, y)) <= 0.0f) ++x;
    const double dry = terrain.heights(x - 1, y) - level;
    const double wet = terrain.heights(x, y) - level;
    EXPECT_GE(dry, 0.0);
    return terrain.spacing * (x - 0.5 + dry / (dry - wet));
}

TEST(Water, TheShoreIsAtTheLevelWithinACell) {
    const Picture picture(drawing(in_the_east));
    for (const float level : {-30.0f, 0.0f, 55.0f}) {
        const Terrain terrain = laid(water(picture.source(), level), level_land(60.0f));
        for (int y = 0; y < 128; ++y) {
            EXPECT_NEAR(shore_in_row(terrain, y, level), 640.0, terrain.spacing) << level;
            // Half a cell from it, at slopes of 0.5 and 0.2.
            EXPECT_NEAR(terrain.heights(63, y), level + 2.5f, 0.1f);
            EXPECT_NEAR(terrain.heights(64, y), level - 1.0f, 0.1f);
        }
    }
}

TEST(Water, TheBedFallsInwardsAndStopsAtDepth) {
    const Picture picture(drawing(in_the_east));
    const Terrain terrain = laid(water(picture.source()), level_land(60.0f));
    for (int x = 64; x < 128; ++x) {
        // Cell centres; 40 m over 200 m.
        const double inwards = (x + 0.5 - 64) * terrain.spacing;
        EXPECT_NEAR(terrain.heights(x, 60), std::max(-40.0, -0.2 * inwards), 1.0) << x;
        EXPECT_LE(terrain.heights(x, 60), terrain.heights(x - 1, 60));
        EXPECT_EQ(terrain.water(x, 60), 0.0f);
    }
    EXPECT_EQ(terrain.water(63, 60), kDry);
}

TEST(Water, TheLandRisesNoSteeperThanItMayFromTheShore) {
    const Picture picture(drawing(in_the_east));
    for (const double slope : {0.2, 0.5, 2.0}) {
        Options options = water(picture.source());
        options.water[0].shore_slope = slope;
        const Terrain terrain = laid(options, level_land(200.0f));
        for (int x = 0; x < 64; ++x) {
            const double inland = (64 - x - 0.5) * terrain.spacing;
            EXPECT_NEAR(terrain.heights(x, 60), std::min(200.0, slope * inland), 1.0);
        }
    }
}

TEST(Water, LandBelowItsLevelKeepsItInWithALowBank) {
    const Picture picture(drawing(in_the_middle));
    const Terrain terrain = laid(water(picture.source(), 30.0), level_land(0.0f));
    for (int x = 0; x < 128; ++x) {
        const bool wet = terrain.water(x, 64) != kDry;
        const bool beside =
            x > 0 && x < 127 &&
            (terrain.water(x - 1, 64) != kDry || terrain.water(x + 1, 64) != kDry);
        if (!wet && beside) {
            EXPECT_GE(terrain.heights(x, 64), 30.0f) << x;
        }
    }
    EXPECT_GT(terrain.heights(64 + 26, 64), 30.0f);
    EXPECT_EQ(terrain.heights(0, 64), 0.0f);
    EXPECT_EQ(terrain.heights(0, 0), 0.0f);
}

TEST(Water, WithoutALevelItIsTheLowestLandOfItsShore) {
    const Picture picture(drawing(in_the_middle));
    Options options = water(picture.source());
    options.water[0].level.reset();
    Terrain slope = level_land(0.0f);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            slope.heights(x, y) = 100.0f + static_cast<float>(x);
    // The western end of the circle lies 0.3 of the width from the west.
    const Terrain terrain = laid(options, slope);
    EXPECT_NEAR(terrain.water(64, 64), 100.0 + 0.3 * 128, 1.0);
    options.water[0].level = metres(10.0);
    EXPECT_EQ(laid(options, slope).water(64, 64), 10.0f);
}

TEST(Water, TwoHaveTheirOwnLevels) {
    const Picture east(drawing([](double e, double) { return e > 0.8; }));
    const Picture west(drawing([](double e, double) { return e < 0.2; }));
    Options options = water(east.source(), -20.0);
    options.water.push_back(water(west.source(), 25.0).water[0]);
    const Terrain terrain = laid(options, level_land(100.0f));
    EXPECT_EQ(terrain.water(120, 64), -20.0f);
    EXPECT_EQ(terrain.heights(127, 64), -60.0f);
    EXPECT_EQ(terrain.water(5, 64), 25.0f);
    EXPECT_EQ(terrain.heights(0, 64), -15.0f);
    EXPECT_EQ(terrain.water(64, 64), kDry);
    EXPECT_EQ(terrain.heights(64, 64), 100.0f);
}

TEST(Water, BesideALowerOneItKeepsItsBank) {
    const Picture low(drawing(in_the_east));
    const Picture high(drawing([](double e, double) { return e < 0.46; }));
    Options options = water(low.source());
    options.water.push_back(water(high.source(), 50.0).water[0]);
    for (int order = 0; order < 2; ++order) {
        const Terrain terrain = laid(options, level_land(80.0f));
        for (int x = 60; x < 64; ++x) {
            if (terrain.water(x, 64) == kDry) {
                EXPECT_GT(terrain.heights(x, 64), 20.0f);
            }
        }
        EXPECT_GT(terrain.heights(59, 64), 50.0f);
        std::swap(options.water[0], options.water[1]);
    }
}

TEST(Water, AllOrNothingIsAnError) {
    for (const bool all : {false, true}) {
        const Picture picture(drawing([all](double, double) { return all; }));
        try {
            laid(water(picture.source()), level_land(60.0f));
            FAIL() << "laid water without a shore";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::kBadRequest);
            const std::string message = error.what();
            EXPECT_NE(message.find(all ? "nothing but water" : "no water"),
                      std::string::npos)
                << message;
        }
    }
}

// A whole stage: three peaks above a crooked shore.
Options stage(const Source& image) {
    Options options = water(image, 40.0);
    options.groups = peaks(3).groups;
    set_range(options, 0.0, 100.0);
    options.sea_level_scale = 3.0;
    options.edge_weight_deviation = 1.5;
    return options;
}

bool crooked(double east, double north) {
    return east > 0.5 + 0.1 * std::sin(9.0 * north);
}

TEST(Water, SameBytesForOneAndFourThreads) {
    const Picture picture(drawing(crooked));
    Field<float> heights, levels;
    for (const std::size_t threads : {1u, 4u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        threads);
        const Terrain terrain = land(stage(picture.source()), flat(128, 128, kExtent));
        if (threads == 4u) {
            EXPECT_EQ(terrain.heights, heights);
            EXPECT_EQ(terrain.water, levels);
        }
        heights = terrain.heights;
        levels = terrain.water;
    }
}

TEST(Water, SameShoreAt256And512Samples) {
    const Picture picture(drawing(crooked, 600));
    const Terrain coarse = land(stage(picture.source()), flat(256, 256, kExtent));
    const Terrain fine = land(stage(picture.source()), flat(512, 512, kExtent));
    for (int y = 0; y < 256; ++y) {
        const double between = 0.5 * (shore_in_row(fine, 2 * y, 40.0f) +
                                      shore_in_row(fine, 2 * y + 1, 40.0f));
        EXPECT_NEAR(shore_in_row(coarse, y, 40.0f), between, 0.5 * coarse.spacing) << y;
    }
}

TEST(Water, IsThereWhereNoLandRises) {
    const Picture picture(drawing(in_the_east));
    Options options = stage(picture.source());
    options.sea_level_scale = 0.5;
    set_range(options, 100.0, 100.0);
    const Terrain terrain = land(options, flat(64, 64, kExtent));
    ASSERT_FALSE(terrain.water.empty());
    EXPECT_EQ(terrain.water(60, 30), 40.0f);
}

TEST(Water, LaterStagesKeepIt) {
    const Picture picture(drawing(in_the_east));
    const Terrain sea = laid(water(picture.source()), level_land(60.0f, 64));
    Options hills = stage(picture.source());
    hills.water.clear();
    EXPECT_EQ(land(hills, sea).water, sea.water);
    hills.combine = Options::Combine::kReplace;
    EXPECT_TRUE(land(hills, sea).water.empty());
}

}  // namespace
}  // namespace cydonia::distance
