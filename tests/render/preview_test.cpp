#include "render/preview.h"

#include <gtest/gtest.h>

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

TEST(Hillshade, AtMostTheLongestSide) {
    const Field<Rgb8> wide = hillshade(fractal(300, 120, 60.0f, 2), 10.0, 100);
    EXPECT_EQ(wide.width(), 100);
    EXPECT_EQ(wide.height(), 40);
    EXPECT_EQ(hillshade(fractal(30, 20, 6.0f, 2), 10.0, 100).width(), 30);
    EXPECT_EQ(hillshade(Field<float>(4000, 1), 1.0, 100).height(), 1);
    EXPECT_TRUE(hillshade({}, 1.0).empty());
}

}  // namespace
}  // namespace cydonia::render
