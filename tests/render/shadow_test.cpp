#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

#include "field/error.h"
#include "render/shadow/caster.h"
#include "tests/render/shadow_land.h"

namespace cydonia::render {
namespace {

TEST(Caster, FlatLandHasNoShadow) {
    for (const float level : {0.0f, 1234.5f, -800.0f}) {
        const Caster caster(Field<float>(100, 60, level), 10.0);
        for (double elevation : {0.01, 1.0, 5.0, 45.0, 90.0})
            for (double azimuth = 0.0; azimuth < 360.0; azimuth += 22.5)
                EXPECT_EQ(area(caster.shadow(sun_at(azimuth, elevation), 2)), 0u)
                    << level << " m, " << azimuth << ", " << elevation;
    }
}

// A plane rising toward `uphill`: lit or dark as a whole, by which side the sun is on.
void expect_lit_or_dark(int n, double slope, double uphill) {
    const double rise = std::tan(radians(slope));
    const double ux = rise * std::sin(radians(uphill));
    const double uy = rise * std::cos(radians(uphill));
    const auto plane = [&](double east, double north) {
        return 500.0 + ux * east + uy * north;
    };
    const Caster caster(land(n, n, 10.0, plane), 10.0);
    for (double elevation : {1.0, 3.0, 15.0, 45.0, 70.0})
        for (double azimuth = 7.0; azimuth < 360.0; azimuth += 90.0) {
            const Sun sun = sun_at(azimuth, elevation);
            const double facing = dot(normalized({-ux, -uy, 1.0}), direction_to(sun));
            if (std::abs(facing) < 0.002) continue;
            EXPECT_EQ(area(caster.shadow(sun, 2)), facing > 0.0 ? 0u : 4u * n * n)
                << slope << " up " << uphill << ", sun " << azimuth << ", " << elevation;
        }
}

TEST(Caster, PlaneIsLitOrDarkAsAWhole) {
    for (const double slope : {2.0, 10.0, 30.0, 60.0, 80.0})
        for (double uphill = 0.0; uphill < 360.0; uphill += 60.0)
            expect_lit_or_dark(50, slope, uphill);
    expect_lit_or_dark(400, 10.0, 40.0);
}

// The dark samples beyond the crest of a wall through the middle of flat land, measured
// along the light, in metres. The wall lies across the light as nearly as a row or a
// column can.
double shadow_length(const Sun& sun, double wall, int rays) {
    constexpr int kSide = 301, kMiddle = 150;
    constexpr double kSpacing = 10.0;
    const bool east_west = std::abs(std::cos(sun.azimuth)) >= std::sqrt(0.5);
    Field<float> heights(kSide, kSide);
    for (int i = 0; i < kSide; ++i)
        (east_west ? heights(i, kMiddle) : heights(kMiddle, i)) =
            static_cast<float>(wall);
    const Mask mask = Caster(heights, kSpacing).shadow(sun, rays);
    const int across = kMiddle * rays + rays / 2;
    int dark = 0;
    for (int i = 0; i < kSide * rays; ++i)
        dark += east_west ? mask(across, i) : mask(i, across);
    const double depth = dark * kSpacing / rays;
    return depth / std::abs(east_west ? std::cos(sun.azimuth) : std::sin(sun.azimuth));
}

TEST(Caster, WallOfHeightHCastsHOverTanElevation) {
    constexpr int kRays = 2;
    constexpr double kWall = 200.0;
    for (const double elevation : {10.0, 25.0, 45.0, 70.0})
        for (int i = 0; i < 16; ++i) {
            const Sun sun = sun_at(22.5 * i + 3.0, elevation);
            // One sub-sample across the wall is at most sqrt(2) of one along the light.
            EXPECT_NEAR(shadow_length(sun, kWall, kRays), kWall / std::tan(sun.elevation),
                        std::sqrt(2.0) * 10.0 / kRays)
                << sun.azimuth << ", " << elevation;
        }
}

TEST(Caster, ShadowFallsAwayFromTheSun) {
    Field<float> heights(41, 41);
    heights(20, 20) = 100.0f;
    const Caster caster(heights, 10.0);
    const auto dark_beside = [&](double azimuth, int x, int y) {
        return caster.shadow(sun_at(azimuth, 45.0), 1)(x, y) == 1;
    };
    EXPECT_TRUE(dark_beside(0.0, 20, 25));    // sun in the north, shadow to the south
    EXPECT_TRUE(dark_beside(90.0, 15, 20));   // sun in the east, shadow to the west
    EXPECT_TRUE(dark_beside(225.0, 24, 16));  // sun in the south-west
    EXPECT_FALSE(dark_beside(0.0, 20, 15));
    EXPECT_FALSE(dark_beside(90.0, 25, 20));
}

TEST(Caster, RaisingTheSunShrinksTheShadow) {
    Field<float> heights(200, 60);
    for (int y = 0; y < 60; ++y) heights(100, y) = 300.0f;
    const Caster caster(heights, 10.0);
    std::size_t last = heights.size() * 4;
    for (double elevation = 18.0; elevation < 89.0; elevation += 3.0) {
        const std::size_t now = area(caster.shadow(sun_at(250.0, elevation), 2));
        EXPECT_LT(now, last) << elevation;
        EXPECT_GT(now, 0u) << elevation;
        last = now;
    }
}

// Two opposite corners of a square raised: along NW-SE they carry a ridge, along SW-NE
// two peaks with a saddle between them.
TEST(Caster, SquaresAreSplitFromNorthWestToSouthEast) {
    Field<float> ridge(41, 41), saddle(41, 41);
    ridge(20, 20) = ridge(21, 21) = 100.0f;
    saddle(21, 20) = saddle(20, 21) = 100.0f;
    constexpr int kRays = 8;
    // From the middle of the square, 5 cells of shadow at half the ridge's height.
    const auto behind = [&](const Field<float>& heights, double azimuth, int dx, int dy) {
        const Mask mask = Caster(heights, 10.0).shadow(sun_at(azimuth, 45.0), kRays);
        return mask(21 * kRays + dx * kRays, 21 * kRays + dy * kRays);
    };
    EXPECT_EQ(behind(ridge, 45.0, -4, 4), 1);     // sun in the north-east
    EXPECT_EQ(behind(ridge, 225.0, 4, -4), 1);    // south-west
    EXPECT_EQ(behind(saddle, 315.0, 4, 4), 0);    // north-west
    EXPECT_EQ(behind(saddle, 135.0, -4, -4), 0);  // south-east
}

// The march at a sample's place, which a hair moves off the diagonal to the north-east.
double cover_at(const Field<float>& heights, const Sun& sun, int rays, int x, int y) {
    const bool corner = (2 * x + 1 - rays) % (2 * rays) == 0;
    const double hair = (x - y) % rays == 0 && !corner ? 1e-6 : 0.0;
    return cover(heights, sun, (x + 0.5) / rays - 0.5 + hair,
                 (y + 0.5) / rays - 0.5 - hair);
}

TEST(Caster, AgreesWithASlowMarchOverTheSameTriangles) {
    const Field<float> heights = fractal(96, 80, 6.0f, 7);
    const Caster caster(heights, 1.0);
    std::size_t samples = 0, wrong = 0, dark = 0;
    double worst = 0.0;
    for (const double elevation : {2.0, 15.0, 40.0})
        for (const double azimuth : {0.0, 33.0, 90.0, 135.0, 200.0, 251.0, 315.0})
            for (const int rays : {1, 2, 3}) {
                const Sun sun = sun_at(azimuth, elevation);
                const Mask mask = caster.shadow(sun, rays);
                for (int y = rays; y < mask.height() - rays; ++y)
                    for (int x = rays; x < mask.width() - rays; ++x) {
                        const double above = cover_at(heights, sun, rays, x, y);
                        ++samples;
                        dark += mask(x, y);
                        if ((above > 1e-9) == (mask(x, y) == 1)) continue;
                        ++wrong;
                        worst = std::max(worst, std::abs(above));
                    }
            }
    EXPECT_LT(worst, 1e-4);  // crests that the ray's start is lifted over
    EXPECT_LE(static_cast<double>(wrong), 1e-4 * static_cast<double>(samples));
    EXPECT_GT(dark, samples / 10);
    EXPECT_LT(dark, samples * 9 / 10);
    RecordProperty("samples", std::to_string(samples));
    RecordProperty("wrong", std::to_string(wrong));
}

TEST(Caster, ThreadsDoNotMatter) {
    const Field<float> heights = fractal(200, 170, 10.0f, 3);
    const auto with = [&](std::size_t threads) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return Caster(heights, 1.0).shadow(sun_at(120.0, 12.0), 2);
    };
    EXPECT_EQ(with(1), with(4));
}

TEST(Caster, SmallestTerrain) {
    Field<float> heights(2, 2);
    EXPECT_EQ(area(Caster(heights, 1.0).shadow(sun_at(200.0, 5.0), 2)), 0u);
    heights(0, 0) = heights(0, 1) =
        5.0f;  // a slope down to the east, the sun in the west
    EXPECT_EQ(area(Caster(heights, 1.0).shadow(sun_at(270.0, 30.0), 2)), 16u);
    EXPECT_EQ(area(Caster(heights, 1.0).shadow(sun_at(90.0, 30.0), 2)), 0u);
}

TEST(Caster, WhatCannotBeCastIsRefused) {
    EXPECT_THROW(Caster(Field<float>(1, 50), 1.0), Error);
    EXPECT_THROW(Caster(Field<float>(50, 1), 1.0), Error);
    EXPECT_THROW(Caster(Field<float>(), 1.0), Error);
    EXPECT_THROW(Caster(Field<float>(16385, 2), 1.0), Error);
    EXPECT_THROW(Caster(Field<float>(4, 4), 0.0), Error);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity()}) {
        Field<float> heights(8, 8);
        heights(3, 5) = bad;
        EXPECT_THROW(Caster(heights, 1.0), Error);
    }
    const Caster caster(Field<float>(4, 4), 1.0);
    EXPECT_THROW(caster.shadow(sun_at(0.0, 0.0), 1), Error);
    EXPECT_THROW(caster.shadow(sun_at(0.0, -5.0), 1), Error);
    EXPECT_THROW(caster.shadow(sun_at(0.0, 10.0), 0), Error);
    EXPECT_THROW(caster.shadow(sun_at(0.0, 10.0), 1000), Error);
}

}  // namespace
}  // namespace cydonia::render
