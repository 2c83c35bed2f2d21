#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "field/error.h"
#include "render/pov/things.h"
#include "render/things/originals.h"
#include "render/things/placement.h"

namespace cydonia::render {
namespace {

using Kind = ThingOptions::Kind;

constexpr double kSpacing = 10.0;
constexpr std::size_t kAll = 1'000'000;

// A plain in the west, at 100 m, and a slope of 50 degrees in the east.
Terrain plain_and_cliff() {
    Terrain t;
    t.spacing = kSpacing;
    t.heights = Field<float>(100, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            t.heights(x, y) = 100.0f + 12.0f * float(std::max(0, x - 60));
    return t;
}

Camera from_above() {
    Camera camera;
    camera.projection = Camera::Projection::kOrthographic;
    camera.eye = {500.0, 500.0, 5000.0};
    camera.target = {500.0, 500.0, 0.0};
    camera.up = {0.0, 1.0, 0.0};
    camera.frame_width = 1000.0;
    camera.width = camera.height = 1000;
    return camera;
}

Camera from_eye_level() {
    Camera camera;
    camera.eye = {100.0, 100.0, 130.0};
    camera.target = {400.0, 400.0, 110.0};
    camera.width = 1280;
    camera.height = 720;
    return camera;
}

ThingOptions conifers() {
    ThingOptions options;
    options.density = 100.0;
    options.clumping = 0.0;
    return options;
}

using Key = std::tuple<double, double, float>;
std::set<Key> keys(const std::vector<Thing>& things) {
    std::set<Key> all;
    for (const Thing& t : things) all.emplace(t.foot.x, t.foot.y, t.height);
    return all;
}

TEST(Things, AsManyAHectareAsAskedForWhereAllSuits) {
    const auto things =
        things_in_view(plain_and_cliff(), conifers(), 0, from_above(), kAll);
    const auto on_plain =
        std::ranges::count_if(things, [](const Thing& t) { return t.foot.x < 550.0; });
    EXPECT_NEAR(double(on_plain), 5500.0, 60.0);  // 55 hectares
}

TEST(Things, NoneOnSteepGround) {
    for (const Thing& t :
         things_in_view(plain_and_cliff(), conifers(), 0, from_above(), kAll))
        EXPECT_LT(t.foot.x, 620.0);
}

TEST(Things, StandOnTheGroundAndRocksInIt) {
    const Terrain land = plain_and_cliff();
    for (const Kind kind : {Kind::kConifer, Kind::kBoulder}) {
        ThingOptions options = conifers();
        options.kind = kind;
        options.size = {{4.0, 4.0}};
        const auto things = things_in_view(land, options, 0, from_above(), kAll);
        ASSERT_FALSE(things.empty());
        for (const Thing& t : things)
            if (t.foot.x < 590.0) {
                EXPECT_NEAR(t.foot.z, 100.0 - 4.0 * habit_of(kind).sunk, 1e-6);
            }
    }
}

TEST(Things, HeightsMasksAndWaterDecideWhere) {
    Terrain land = plain_and_cliff();
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            land.heights(x, y) = float(10 * y);  // south is high
    land.masks["wood"] = Field<float>(100, 100, 0.0f);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 50; ++x) land.masks["wood"](x, y) = 1.0f;
    land.water = Field<float>(100, 100, kDry);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 100; ++x) land.water(x, y) = 200.0f;
    ThingOptions options = conifers();
    options.slope = {{radians(80.0), radians(85.0)}};
    options.mask = "wood";
    options.to = metres(600.0);
    const auto things = things_in_view(land, options, 0, from_above(), kAll);
    EXPECT_GT(things.size(), 1000u);
    double low = 0.0, high = 0.0;
    int lows = 0, highs = 0;
    for (const Thing& t : things) {
        EXPECT_LT(t.foot.x, 506.0);
        EXPECT_LT(t.foot.z, 600.0);
        EXPECT_LT(t.foot.y, 806.0);  // north of it is water
        if (t.foot.z < 400.0) low += t.height, ++lows;
        if (t.foot.z > 560.0) high += t.height, ++highs;
    }
    ASSERT_GT(highs, 5);
    EXPECT_LT(high / highs, 0.6 * low / lows);  // small at the tree line
}

TEST(Things, NoneInAShadowImageUnlessAskedFor) {
    Terrain land = plain_and_cliff();
    land.shadows.push_back({"text", Field<std::uint8_t>(100, 100), {}});
    EXPECT_TRUE(things_in_view(land, conifers(), 0, from_above(), kAll).empty());
    ThingOptions options = conifers();
    options.in_image = true;
    EXPECT_FALSE(things_in_view(land, options, 0, from_above(), kAll).empty());
}

TEST(Things, AMovedCameraFindsTheSameOnes) {
    const Terrain land = plain_and_cliff();
    const auto all = keys(things_in_view(land, conifers(), 0, from_above(), kAll));
    const auto seen = keys(things_in_view(land, conifers(), 0, from_eye_level(), kAll));
    EXPECT_GT(seen.size(), 50u);
    EXPECT_LT(seen.size(), all.size());
    EXPECT_TRUE(std::ranges::includes(all, seen));
}

TEST(Things, OneThreadOrFour) {
    const Terrain land = plain_and_cliff();
    const auto made = [&](std::size_t threads) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Shot shot;
        shot.camera = from_eye_level();
        shot.options.things = {conifers()};
        return pov::things(shot, land);
    };
    EXPECT_EQ(made(1), made(4));
}

TEST(Things, TheNearestStayWhenThereAreTooMany) {
    const Terrain land = plain_and_cliff();
    ThingOptions options = conifers();
    options.size = {{10.0, 10.0}};
    const auto few = things_in_view(land, options, 0, from_eye_level(), 300);
    const auto all = things_in_view(land, options, 0, from_eye_level(), kAll);
    ASSERT_EQ(few.size(), 300u);
    ASSERT_GT(all.size(), 600u);
    const auto count = [](const std::vector<Thing>& things, double from, double to) {
        return double(std::ranges::count_if(things, [&](const Thing& t) {
            const double d = std::hypot(t.foot.x - 100.0, t.foot.y - 100.0);
            return d >= from && d < to;
        }));
    };
    EXPECT_GT(count(all, 0.0, 40.0), 20.0);
    EXPECT_EQ(count(few, 0.0, 40.0), count(all, 0.0, 40.0));
    EXPECT_LT(count(few, 300.0, 600.0), 0.4 * count(all, 300.0, 600.0));
    EXPECT_GT(count(few, 300.0, 600.0), 10.0);
}

TEST(Things, BehindACrestThereAreNone) {
    Terrain land = plain_and_cliff();
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            land.heights(x, y) = x == 50 || x == 51 ? 400.0f : 100.0f;
    Camera camera = from_eye_level();
    camera.eye = {50.0, 500.0, 120.0};
    camera.target = {900.0, 500.0, 120.0};
    for (const Thing& t : things_in_view(land, conifers(), 0, camera, kAll))
        EXPECT_LT(t.foot.x, 540.0);
}

TEST(Things, AnUnknownMaskIsNamedWithThoseThereAre) {
    Terrain land = plain_and_cliff();
    land.masks["scree"] = Field<float>(100, 100, 1.0f);
    ThingOptions options = conifers();
    options.mask = "wood";
    try {
        things_in_view(land, options, 0, from_above(), kAll);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("no mask 'wood': this land has scree"),
                  std::string::npos);
    }
}

TEST(Originals, AreAMetreHighAndOverTheirFoot) {
    for (int kind = 0; kind < 6; ++kind)
        for (int number = 0; number < kOriginals; ++number) {
            float low = 1e9f, high = -1e9f;
            for (const auto& part : original_of(Kind(kind), number).parts)
                for (const auto& v : part.vertices) {
                    low = std::min(low, v[2]);
                    high = std::max(high, v[2]);
                    EXPECT_LT(std::hypot(v[0], v[1]), 1.6);
                }
            EXPECT_GT(low, -0.2f) << kind;
            EXPECT_FLOAT_EQ(high, 1.0f) << kind << ' ' << number;
        }
}

}  // namespace
}  // namespace cydonia::render
