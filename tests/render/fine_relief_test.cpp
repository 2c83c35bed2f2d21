#include "render/fine_relief/fine_relief.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "field/noise.h"
#include "render/fine_relief/craters.h"
#include "render/fine_relief/gullies.h"

using namespace cydonia;
using namespace cydonia::render;

namespace {

constexpr int kSide = 96;
constexpr double kSpacing = 20.0;

Terrain land(const auto& height_at) {
    Terrain terrain;
    terrain.spacing = kSpacing;
    terrain.heights = Field<float>(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            terrain.heights(x, y) = static_cast<float>(height_at(x, y));
    return terrain;
}

// Falls to the east.
Terrain slope(double rise) {
    return land([&](int x, int) { return -rise * kSpacing * x; });
}

Terrain hills() {
    return land([](int x, int y) {
        return 900.0 * gradient_noise(x / 31.0, y / 31.0, 5) +
               300.0 * gradient_noise(x / 13.0, y / 13.0, 6);
    });
}

double rms(const Field<float>& a, const auto& other) {
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) sum += std::pow(a(x, y) - other(x, y), 2.0);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

Field<float> block_means(const Field<float>& fine, int factor) {
    Field<float> means(fine.width() / factor, fine.height() / factor);
    for (int y = 0; y < fine.height(); ++y)
        for (int x = 0; x < fine.width(); ++x)
            means(x / factor, y / factor) +=
                fine(x, y) / static_cast<float>(factor * factor);
    return means;
}

// Root mean square of the rise between samples side by side, east and south.
struct Roughness {
    double east, south;
};
Roughness roughness(const Field<float>& field) {
    Roughness r{};
    for (int y = 0; y + 1 < field.height(); ++y)
        for (int x = 0; x + 1 < field.width(); ++x) {
            r.east += std::pow(field(x + 1, y) - field(x, y), 2.0);
            r.south += std::pow(field(x, y + 1) - field(x, y), 2.0);
        }
    const auto n = static_cast<double>(field.size());
    return {std::sqrt(r.east / n), std::sqrt(r.south / n)};
}

}  // namespace

TEST(FineRelief, KeepsExtentAndMeanHeights) {
    const Terrain base = hills();
    const Terrain fine = with_fine_relief(base, {}, 4, 1);
    EXPECT_EQ(fine.heights.width(), 4 * kSide);
    EXPECT_DOUBLE_EQ(fine.spacing, kSpacing / 4.0);
    const Field<float> means = block_means(fine.heights, 4);
    const double moved = rms(means, [&](int x, int y) { return base.heights(x, y); });
    const auto [low, high] = std::ranges::minmax(base.heights);
    EXPECT_LT(moved, 0.01 * (high - low));
    // And it did add form: not what lies between the samples.
    EXPECT_GT(rms(fine.heights, [&](int x, int y) { return means(x / 4, y / 4); }), 1.0);
}

TEST(FineRelief, IsTheSameForAnyNumberOfThreads) {
    const auto made = [](std::size_t threads) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        FineReliefOptions all;
        all.terraces = all.craters = 1.0;
        return with_fine_relief(hills(), all, 4, 7).heights;
    };
    const Field<float> one = made(1), four = made(4);
    EXPECT_TRUE(std::ranges::equal(one, four));
}

TEST(FineRelief, MoreSamplesKeepTheOctavesOfFewer) {
    const Terrain base = hills();
    const Field<float> two = with_fine_relief(base, {}, 2, 1).heights;
    const Field<float> eight = block_means(with_fine_relief(base, {}, 8, 1).heights, 4);
    const double added =
        rms(two, [&](int x, int y) { return base.heights(x / 2, y / 2); });
    EXPECT_LT(rms(two, [&](int x, int y) { return eight(x, y); }), 0.25 * added);
}

TEST(FineRelief, LevelGroundStaysNearlyLevel) {
    const Field<float> level = with_fine_relief(slope(0.02), {}, 4, 1).heights;
    const Field<float> steep = with_fine_relief(slope(0.7), {}, 4, 1).heights;
    EXPECT_LT(roughness(level).south, 0.12 * roughness(steep).south);
    EXPECT_GT(roughness(level).south, 0.0);
}

TEST(FineRelief, WaterStaysLevelAndItsBedAsItIs) {
    Terrain base = hills();
    base.water = Field<float>(kSide, kSide, kDry);
    for (std::size_t i = 0; i < base.water.size(); ++i)
        if (base.heights[i] < -50.0f) base.water[i] = -50.0f;
    FineReliefOptions all;
    all.terraces = 1.0;
    const Terrain fine = with_fine_relief(base, all, 4, 1);
    int wet = 0;
    double most = 0.0;
    for (int y = 8; y < kSide - 8; ++y)
        for (int x = 8; x < kSide - 8; ++x) {
            if (water_depth(base, base.heights.index(x, y)) < 40.0f) continue;
            ++wet;
            const std::size_t i = fine.heights.index(4 * x + 2, 4 * y + 2);
            EXPECT_EQ(fine.water[i], -50.0f);
            most = std::max<double>(most, std::abs(fine.heights[i] - base.heights(x, y)));
        }
    EXPECT_GT(wet, 100);
    EXPECT_LT(most, 20.0);  // what a cubic makes of the slopes between samples
    // No water at another level.
    for (std::size_t i = 0; i < fine.water.size(); ++i)
        if (fine.water[i] != kDry) {
            ASSERT_EQ(fine.water[i], -50.0f);
        }
}

TEST(FineRelief, ShadowImagesKeepTheirPlaces) {
    Terrain base = hills();
    base.shadows.push_back({"t", Field<std::uint8_t>(kSide, kSide), {}});
    base.shadows[0].target(10, 20) = 1;
    base.masks["m"] = Field<float>(kSide, kSide, 0.25f);
    const Terrain fine = with_fine_relief(base, {}, 2, 1);
    EXPECT_EQ(fine.shadows[0].target(20, 40), 1);
    EXPECT_EQ(fine.shadows[0].target(21, 41), 1);
    EXPECT_EQ(fine.shadows[0].target(22, 40), 0);
    EXPECT_EQ(fine.masks.at("m")(100, 100), 0.25f);
}

TEST(Gullies, RunDownTheSlope) {
    const Field<float> field = gullies(slope(0.8).heights, kSpacing, 160.0, 3);
    const Roughness r = roughness(field);
    EXPECT_GT(r.south, 2.5 * r.east);
}

TEST(Gullies, AreAWavelengthApart) {
    const Field<float> field = gullies(slope(0.8).heights, kSpacing, 160.0, 3);
    // Ups through the middle along lines across the fall: one a gully.
    double crossings = 0.0;
    for (int x = 8; x < kSide - 8; ++x)
        for (int y = 8; y + 1 < kSide - 8; ++y)
            crossings += field(x, y) < 0.0f && field(x, y + 1) >= 0.0f;
    const double length = (kSide - 17) * kSpacing * (kSide - 16);
    EXPECT_NEAR(length / crossings, 160.0, 40.0);
}

TEST(Gullies, NeedASlope) {
    for (const float v : gullies(slope(0.1).heights, kSpacing, 160.0, 3))
        ASSERT_EQ(v, 0.0f);
}

TEST(Craters, AreAFifthAsDeepAsWide) {
    const double diameter = 300.0;
    const Field<float> field = craters(600, 600, 5.0, diameter, 2);
    const auto [low, high] = std::ranges::minmax(field);
    EXPECT_LT(low, -0.08 * diameter);
    EXPECT_GT(low, -0.45 * diameter);  // two may share a place
    EXPECT_GT(high, 0.01 * diameter);  // rims
    EXPECT_LT(high, 0.1 * diameter);
    // Between them nothing was added.
    EXPECT_GT(std::ranges::count(field, 0.0f), 20000);
}

TEST(FineRelief, TerracesAreWallsAndBenches) {
    FineReliefOptions options{.gullies = 0.0, .crags = 0.0};
    const auto steepest_and_flattest = [&](double terraces) {
        options.terraces = terraces;
        const Field<float> h = with_fine_relief(slope(0.5), options, 4, 1).heights;
        std::vector<double> rises;
        for (int x = 16; x + 17 < h.width(); ++x)
            rises.push_back((h(x, 200) - h(x + 1, 200)) / (kSpacing / 4.0));
        std::ranges::sort(rises);
        return std::pair{rises[rises.size() / 5], rises[rises.size() * 4 / 5]};
    };
    const auto [smooth_low, smooth_high] = steepest_and_flattest(0.0);
    EXPECT_NEAR(smooth_low, 0.5, 0.01);
    EXPECT_NEAR(smooth_high, 0.5, 0.01);
    const auto [bench, wall] = steepest_and_flattest(1.0);
    EXPECT_LT(bench, 0.3);
    EXPECT_GT(wall, 0.7);
}

TEST(FineRelief, FactorsFollowQuality) {
    EXPECT_EQ(fine_factor({}, 512, Quality::kDraft), 2);
    EXPECT_EQ(fine_factor({}, 512, Quality::kPreview), 4);
    EXPECT_EQ(fine_factor({}, 512, Quality::kFinal), 8);
    EXPECT_EQ(fine_factor({}, 64, Quality::kFinal), 8);
    EXPECT_EQ(fine_factor({}, 5000, Quality::kFinal), 1);
    EXPECT_EQ(fine_factor({.factor = 2}, 5000, Quality::kDraft), 2);
}
