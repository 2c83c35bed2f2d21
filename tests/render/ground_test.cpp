#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "render/ground/ground.h"
#include "render/ground/relief.h"

using namespace cydonia;
using namespace cydonia::render;

namespace {

constexpr int kSide = 128;

Material plain(const char* name, float grey) {
    Material m;
    m.name = name;
    m.light = m.dark = {grey, grey, grey};
    return m;
}

// Black ground, and white where `layer` lies.
GroundOptions white_where(const Layer& layer) {
    Layer white = layer;
    white.material = 1;
    GroundOptions options;
    options.look = {
        "test", {plain("black", 0.1f), plain("white", 0.9f)}, {Layer{}, white}, {}, {}};
    return options;
}

Terrain level_land() {
    Terrain terrain;
    terrain.spacing = 20.0;
    terrain.heights = Field<float>(kSide, kSide, 0.0f);
    return terrain;
}

// Rises from 0 in the south to `top` in the north.
Terrain ramp(double top) {
    Terrain terrain = level_land();
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            terrain.heights(x, y) =
                static_cast<float>(top * (kSide - 1 - y) / (kSide - 1));
    return terrain;
}

// The share of the rows [first, last) that is white.
double white(const Field<Rgb>& albedo, int first, int last) {
    double sum = 0.0;
    for (int y = first; y < last; ++y)
        for (int x = 0; x < albedo.width(); ++x) sum += albedo(x, y)[0] > 0.5f;
    return sum / (last - first) / albedo.width();
}

double white(const Terrain& terrain, const Layer& layer) {
    return white(ground_albedo(terrain, white_where(layer), 1), 0, kSide);
}

}  // namespace

// All of it above, none below, and between them a border that is no contour line.
TEST(GroundLayer, BorderByHeightWanders) {
    Layer layer;
    layer.above = {{{0.4, true}, {0.6, true}}};
    const Field<Rgb> albedo = ground_albedo(ramp(400.0), white_where(layer), 1);
    EXPECT_EQ(white(albedo, 0, 25), 1.0);
    EXPECT_EQ(white(albedo, kSide - 25, kSide), 0.0);
    const int middle = kSide / 2;
    EXPECT_GT(white(albedo, middle - 1, middle + 1), 0.1);
    EXPECT_LT(white(albedo, middle - 1, middle + 1), 0.9);
}

TEST(GroundLayer, SharesOfTheReliefFollowTheLand) {
    Layer layer;
    layer.above = {{{0.4, true}, {0.6, true}}};
    Terrain high = ramp(400.0);
    for (float& h : high.heights) h = 3.0f * h + 1000.0f;
    const Field<Rgb> low = ground_albedo(ramp(400.0), white_where(layer), 1);
    const Field<Rgb> lifted = ground_albedo(high, white_where(layer), 1);
    for (std::size_t i = 0; i < low.size(); ++i)
        ASSERT_NEAR(low[i][0], lifted[i][0], 0.01f) << i;
}

TEST(GroundLayer, SlopeSidesAndHollows) {
    Layer steep;
    steep.slope = Ramp{radians(20.0), radians(30.0)};
    EXPECT_EQ(white(ramp(100.0), steep), 0.0);
    EXPECT_EQ(white(ramp(2500.0), steep), 1.0);
    Layer north;
    north.north = Ramp{0.2, 0.4};
    Terrain to_south = ramp(2500.0), to_north = to_south;
    std::ranges::reverse(to_north.heights);
    EXPECT_EQ(white(to_south, north), 0.0);
    EXPECT_EQ(white(to_north, north), 1.0);
    Terrain pit = level_land();
    pit.heights(64, 64) = -60.0f;
    Layer hollow;
    hollow.hollow = Ramp{10.0, 30.0};
    const Field<Rgb> albedo = ground_albedo(pit, white_where(hollow), 1);
    EXPECT_GT(albedo(64, 64)[0], 0.5f);
    EXPECT_EQ(white(albedo, 0, 50), 0.0);
}

TEST(GroundLayer, LiesByMaskAndNowhereWithoutIt) {
    Layer layer;
    layer.mask = "wood";
    Terrain terrain = level_land();
    EXPECT_EQ(white(terrain, layer), 0.0);
    Field<float>& mask = terrain.masks["wood"] = Field<float>(kSide, kSide, 0.0f);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < kSide; ++x) mask(x, y) = 1.0f;
    const Field<Rgb> albedo = ground_albedo(terrain, white_where(layer), 1);
    EXPECT_EQ(white(albedo, 42, kSide), white(albedo, 80, kSide));
    EXPECT_GT(white(albedo, 0, 38), white(albedo, 42, kSide) + 0.7);
}

TEST(GroundLayer, PatchesCoverTheirShare) {
    for (const double share : {0.2, 0.5, 0.8}) {
        Layer layer;
        layer.patches = share;
        layer.patch_size = 60.0;
        EXPECT_NEAR(white(level_land(), layer), share, 0.1);
    }
}

TEST(GroundLayer, SnowLineAndRockSlopeOfTheSceneGoFirst) {
    Layer snow;
    snow.role = Layer::Role::kSnow;
    snow.above = {{{1e6, false}, {2e6, false}}};
    GroundOptions options = white_where(snow);
    EXPECT_EQ(white(ground_albedo(ramp(2000.0), options, 1), 0, kSide), 0.0);
    options.snow_line = metres(1000.0);
    const Field<Rgb> albedo = ground_albedo(ramp(2000.0), options, 1);
    EXPECT_EQ(white(albedo, 0, 40), 1.0);
    EXPECT_EQ(white(albedo, kSide - 40, kSide), 0.0);
    Layer rock;
    rock.role = Layer::Role::kRock;
    rock.slope = Ramp{radians(80.0), radians(85.0)};
    options = white_where(rock);
    options.rock_slope = {radians(10.0), radians(20.0)};
    EXPECT_EQ(white(ground_albedo(ramp(2500.0), options, 1), 0, kSide), 1.0);
}

// A wall's beds lie by height: along a level line they are alike, up the wall they
// change.
TEST(GroundMaterial, StrataLieByHeightOnSteepFaces) {
    GroundOptions options;
    Material& rock = options.look.materials[0] = plain("rock", 0.3f);
    rock.strata = Strata{{{0.6f, 0.6f, 0.6f}, {0.1f, 0.1f, 0.1f}}, 120.0, 1.0};
    const auto changes = [](const Field<Rgb>& a, int dx, int dy) {
        double sum = 0.0;
        for (int y = 0; y < kSide - 1; ++y)
            for (int x = 0; x < kSide - 1; ++x)
                sum += std::abs(a(x + dx, y + dy)[0] - a(x, y)[0]);
        return sum;
    };
    const Field<Rgb> wall = ground_albedo(ramp(2500.0), options, 1);
    EXPECT_GT(changes(wall, 0, 1), 3.0 * changes(wall, 1, 0));
    EXPECT_EQ(changes(ground_albedo(ramp(100.0), options, 1), 0, 1), 0.0);
}

TEST(GroundMap, NamesTheMaterialOnTop) {
    Layer layer;
    layer.above = {{{0.4, true}, {0.6, true}}};
    layer.soft = 0.0;
    const GroundOptions options = white_where(layer);
    const GroundMap map = ground_map(ramp(400.0), options, 2);
    ASSERT_TRUE(map.materials.same_shape(map.albedo));
    std::set<int> seen;
    for (std::size_t i = 0; i < map.albedo.size(); ++i) {
        EXPECT_EQ(map.materials[i] == 1, map.albedo[i][0] > 0.5f);
        seen.insert(map.materials[i]);
    }
    EXPECT_EQ(seen, (std::set{0, 1}));
}

// Land that drains into one channel is wettest there, the more the farther down.
TEST(Relief, WaterGathersInValleys) {
    Terrain valley = level_land();
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            valley.heights(x, y) =
                static_cast<float>(5.0 * std::abs(x - 64) + 1.0 * (kSide - y));
    const Relief r = relief_of(valley, true);
    EXPECT_GT(r.forms(64, 100).wet, r.forms(20, 100).wet + 2.0f);
    EXPECT_GT(r.forms(64, 110).wet, r.forms(64, 20).wet + 0.5f);
    EXPECT_EQ(relief_of(valley, false).forms(64, 100).wet, 0.0f);
}

TEST(Relief, OfOneRowAndOneCell) {
    Terrain thin;
    thin.spacing = 5.0;
    for (const auto& [w, h] : {std::pair{2, 1}, std::pair{1, 1}, std::pair{1, 7}}) {
        thin.heights = Field<float>(w, h, 3.0f);
        for (const Rgb& c : ground_albedo(thin, white_where({}), 3))
            EXPECT_TRUE(std::isfinite(c[0]));
    }
}
