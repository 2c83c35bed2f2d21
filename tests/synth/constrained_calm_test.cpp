#include "synth/pareidolia/constrained/calm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field/noise.h"
#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

Terrain bumpy(int width, int height, double relief, double level = 0.0) {
    Terrain terrain;
    terrain.heights =
        noise_field({.h = 1.0, .octaves = 5, .grid = 4.0}, width, height, relief, 11);
    for (float& h : terrain.heights) h += static_cast<float>(level);
    terrain.spacing = 10.0;
    return terrain;
}

ShadowImage with_window(ShadowImage image, Field<std::uint8_t> window) {
    image.window = std::move(window);
    return image;
}

// Metres a cell, east and south, in the middle of a box of cells.
std::pair<double, double> mean_slope(const Field<float>& h, int x0, int y0, int x1,
                                     int y1) {
    double east = 0.0, south = 0.0;
    for (int y = y0; y <= y1; ++y) east += h(x1, y) - h(x0, y);
    for (int x = x0; x <= x1; ++x) south += h(x, y1) - h(x, y0);
    return {east / (x1 - x0) / (y1 - y0 + 1), south / (y1 - y0) / (x1 - x0 + 1)};
}

double roughness(const Field<float>& h, int x0, int y0, int x1, int y1) {
    double sum = 0.0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x)
            sum += std::abs(4.0 * h(x, y) - h(x - 1, y) - h(x + 1, y) - h(x, y - 1) -
                            h(x, y + 1));
    return sum;
}

}  // namespace

TEST(Calm, WithoutImagesTheBaseStays) {
    double smoothed = 1.0;
    for (const auto& [width, height] : {std::pair{64, 64}, {97, 61}, {61, 97}}) {
        const Terrain base = bumpy(width, height, 100.0, 2000.0);
        const Field<float> land = calmed(base, {}, 1.0, &smoothed);
        double worst = 0.0;
        for (std::size_t i = 0; i < land.size(); ++i)
            worst = std::max(worst, std::abs(double(land[i]) - base.heights[i]));
        EXPECT_LT(worst, 0.5) << width << " x " << height;
        EXPECT_EQ(smoothed, 0.0);
    }
}

TEST(Calm, GentleLandIsNotSmoothed) {
    double smoothed = 1.0;
    calmed(bumpy(96, 96, 20.0),
           {with_window(image_of(box(96, 96, 30, 30, 60, 60), 90.0),
                        box(96, 96, 20, 20, 76, 76))},
           1.0, &smoothed);
    EXPECT_LT(smoothed, 0.1);
    EXPECT_GE(smoothed, 0.0);
}

TEST(Calm, SteepLandIsSmoothedAndSaysSo) {
    double smoothed = 0.0;
    const Terrain base = bumpy(96, 96, 2000.0);
    const Field<float> land =
        calmed(base,
               {with_window(image_of(box(96, 96, 44, 44, 50, 50), 90.0),
                            box(96, 96, 20, 20, 76, 76))},
               0.0, &smoothed);
    EXPECT_GT(smoothed, 0.5);
    // In lit ground of the window, too.
    EXPECT_LT(roughness(land, 30, 30, 40, 66),
              0.6 * roughness(base.heights, 30, 30, 40, 66));
    EXPECT_NEAR(roughness(land, 2, 2, 94, 16), roughness(base.heights, 2, 2, 94, 16),
                0.05 * roughness(base.heights, 2, 2, 94, 16));
}

TEST(Calm, ShadowIsCalmerTheMoreItHides) {
    const Terrain base = bumpy(96, 96, 60.0);
    const std::vector<ShadowImage> images{with_window(
        image_of(box(96, 96, 30, 30, 66, 66), 90.0), box(96, 96, 20, 20, 76, 76))};
    double smoothed = 0.0;
    double before = 1e30;
    for (const double hidden : {0.0, 1.0, 2.0}) {
        const double now =
            roughness(calmed(base, images, hidden, &smoothed), 40, 40, 56, 56);
        EXPECT_LT(now, 0.8 * before) << hidden;
        before = now;
    }
}

TEST(Calm, ShadowFallsAlongTheLight) {
    Terrain base;
    base.heights = Field<float>(96, 96, 500.0f);
    base.spacing = 10.0;
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0, 35.0}) {
        double smoothed = 0.0;
        const Field<float> land =
            calmed(base,
                   {with_window(image_of(box(96, 96, 30, 30, 66, 66), azimuth),
                                box(96, 96, 20, 20, 76, 76))},
                   1.0, &smoothed);
        const auto [east, south] = mean_slope(land, 42, 42, 54, 54);
        const double fall =
            -(-std::sin(radians(azimuth)) * east + std::cos(radians(azimuth)) * south);
        const double across =
            std::cos(radians(azimuth)) * east + std::sin(radians(azimuth)) * south;
        const double light = std::tan(radians(25.0)) * 10.0;
        EXPECT_GT(fall, 0.2 * light) << azimuth;
        EXPECT_LT(fall, 1.3 * light) << azimuth;
        EXPECT_LT(std::abs(across), 0.1 * light) << azimuth;
        // Far from the image the ground stays level.
        const auto [far_east, far_south] = mean_slope(land, 2, 2, 10, 10);
        EXPECT_LT(std::hypot(far_east, far_south), 0.25 * light) << azimuth;
    }
}
