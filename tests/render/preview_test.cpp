#include "render/maps/hillshade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/render/shadow_land.h"

namespace cydonia::render {
namespace {

// A plane rising toward `uphill`, in its middle.
float shade_of_slope(double uphill) {
    const double a = radians(uphill);
    const auto plane = [&](double east, double north) {
        return 0.5 * (std::sin(a) * east + std::cos(a) * north);
    };
    return relief(land(9, 9, 10.0, plane), 10.0)(4, 4);
}

TEST(Relief, LightComesFromTheNorthWest) {
    const float toward = shade_of_slope(135.0), away = shade_of_slope(315.0);
    EXPECT_GT(toward, 0.9f);
    EXPECT_LT(away, 0.35f);
    EXPECT_GT(shade_of_slope(45.0), away);  // along the light: between the two
    EXPECT_LT(shade_of_slope(45.0), toward);
}

TEST(Relief, FlatLandIsOneTone) {
    const Field<float> flat = relief(Field<float>(20, 10, 300.0f), 5.0);
    for (const float shade : flat) EXPECT_EQ(shade, flat[0]);
    EXPECT_GT(flat[0], 0.6f);
    EXPECT_LT(flat[0], 0.95f);
}

TEST(Relief, UnitsDoNotMatter) {
    Field<float> metres = fractal(40, 30, 60.0f, 2), millimetres = metres;
    for (float& z : millimetres) z *= 1024.0f;
    EXPECT_EQ(relief(metres, 4.0), relief(millimetres, 4096.0));
}

Terrain terrain_of(Field<float> heights) {
    Terrain terrain;
    terrain.heights = std::move(heights);
    terrain.spacing = 10.0;
    return terrain;
}

TEST(Hillshade, AtMostTheLongestSide) {
    const Field<Rgb8> wide = hillshade(terrain_of(fractal(300, 120, 60.0f, 2)), 100);
    EXPECT_EQ(wide.width(), 100);
    EXPECT_EQ(wide.height(), 40);
    EXPECT_EQ(hillshade(terrain_of(fractal(30, 20, 6.0f, 2)), 100).width(), 30);
    EXPECT_EQ(hillshade(terrain_of(Field<float>(4000, 1)), 100).height(), 1);
    EXPECT_TRUE(hillshade(Terrain()).empty());
}

bool is_bluish(Rgb8 pixel) { return pixel[2] > pixel[1] && pixel[1] > pixel[0]; }

// Land that falls to the east and goes on under a sea.
Terrain shore(int side) {
    Terrain terrain = terrain_of(land(side, side, 10.0, [side](double east, double) {
        return 0.5 * (5.0 * side - east);
    }));
    terrain.water = Field<float>(side, side, kDry);
    for (int y = 0; y < side; ++y)
        for (int x = side / 2; x < side; ++x) terrain.water(x, y) = 0.0f;
    return terrain;
}

TEST(Hillshade, WaterIsBlueAndDarkerWhereItIsDeep) {
    for (const int longest : {64, 16}) {
        const Field<Rgb8> picture = hillshade(shore(64), longest);
        const int shallow = longest / 2 + 1, deep = longest - 2, y = longest / 2;
        for (int x = 0; x < longest; ++x)
            EXPECT_EQ(is_bluish(picture(x, y)), x >= longest / 2) << x;
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_LT(picture(deep, y)[c], picture(shallow, y)[c]);
    }
}

TEST(Hillshade, WaterUnderTheLandDoesNotShow) {
    Terrain buried = shore(32), dry = shore(32);
    dry.water = {};
    for (float& level : buried.water) level = std::min(level, -1000.0f);
    EXPECT_EQ(hillshade(buried), hillshade(dry));
}

}  // namespace
}  // namespace cydonia::render
