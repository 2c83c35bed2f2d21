#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "field/noise.h"
#include "synth/statistics/analysis.h"

namespace cydonia::statistics {
namespace {

using enum Quantity;

Terrain land(Field<float> heights) {
    Terrain terrain;
    terrain.heights = std::move(heights);
    terrain.spacing = 30.0;
    return terrain;
}

Terrain hills(double height, std::uint64_t seed, int width, int depth) {
    NoiseOptions noise;
    noise.octaves = 6;
    noise.h = 1.0;
    return land(noise_field(noise, width, depth, height, seed));
}

const Statistics& of(const Analysis& analysis, Quantity quantity) {
    return analysis[std::size_t(quantity)];
}

Field<int> halves(int width, int depth) {
    Field<int> regions(width, depth);
    for (int y = 0; y < depth; ++y)
        for (int x = width / 2; x < width; ++x) regions(x, y) = 1;
    return regions;
}

// A half of the whole is what it is alone, but for what windows and blurs bring in.
TEST(Regions, AHalfIsTheHalfAlone) {
    const Terrain whole = hills(500.0, 4, 512, 256);
    const auto both = analyses_of(whole, halves(512, 256), 2);
    for (const int side : {0, 1}) {
        Field<float> heights(256, 256);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                heights(x, y) = whole.heights(x + 256 * side, y);
        const Analysis alone = analysis_of(land(std::move(heights)));
        const Analysis& half = both[std::size_t(side)];
        EXPECT_NEAR(of(half, kElevation).mean, of(alone, kElevation).mean, 1e-6);
        EXPECT_EQ(of(half, kElevation).count, of(alone, kElevation).count);
        for (int q = 0; q < kQuantities; ++q) {
            const Statistics &a = half[std::size_t(q)], &b = alone[std::size_t(q)];
            EXPECT_NEAR(a.mean, b.mean, 0.25 * b.deviation)
                << kQuantityNames[std::size_t(q)];
            EXPECT_NEAR(a.deviation, b.deviation, 0.2 * b.deviation)
                << kQuantityNames[std::size_t(q)];
        }
    }
}

TEST(Regions, AllIsTheWhole) {
    const Terrain whole = hills(500.0, 5, 128, 96);
    const Analysis a = analysis_of(whole),
                   b = analysis_of(whole, Field<std::uint8_t>(128, 96, 1));
    for (std::size_t q = 0; q < a.size(); ++q) {
        EXPECT_EQ(a[q].count, b[q].count);
        EXPECT_EQ(a[q].mean, b[q].mean);
    }
    const Analysis none = analysis_of(whole, Field<std::uint8_t>(128, 96, 0));
    for (const Statistics& s : none) EXPECT_EQ(s.count, 0u);
}

// Land outside, however wild, does not count.
TEST(Regions, OutsideDoesNotCount) {
    Terrain whole = hills(500.0, 6, 256, 128);
    const Field<int> regions = halves(256, 128);
    const Analysis before = analyses_of(whole, regions, 1)[0];
    for (int y = 0; y < 128; ++y)
        for (int x = 192; x < 256; ++x)
            whole.heights(x, y) += float((x * 37 + y * 91) % 999);
    const Analysis after = analyses_of(whole, regions, 1)[0];
    for (std::size_t q = 0; q < before.size(); ++q)
        EXPECT_NEAR(before[q].mean, after[q].mean, 1e-3 * before[q].deviation)
            << kQuantityNames[q];
}

TEST(Quantities, SinesHaveADirection) {
    for (const double angle : {0.0, 0.5, 1.2}) {
        Field<float> waves(128, 128);
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x)
                waves(x, y) = float(
                    80.0 * std::sin((x * std::cos(angle) + y * std::sin(angle)) * 0.5));
        const Analysis analysis = analysis_of(land(std::move(waves)));
        EXPECT_GT(of(analysis, kDirectionality).mean, 0.97) << angle;
        // All crests of one wave are ridges.
        EXPECT_GT(of(analysis, kRidgeLength).mean, 60 * 30.0) << angle;
    }
    EXPECT_LT(of(analysis_of(hills(500.0, 7, 128, 128)), kDirectionality).mean, 0.7);
    EXPECT_EQ(of(analysis_of(land(Field<float>(96, 96, 3.0f))), kDirectionality).count,
              0u);
}

// Rougher land has less of its variance in coarse bands.
TEST(Quantities, SpectrumTellsRoughFromSmooth) {
    NoiseOptions noise;
    noise.octaves = 8;
    std::array<double, 2> mean{};
    for (const double h : {0.3, 1.2}) {
        noise.h = h;
        mean[h > 1.0] =
            of(analysis_of(land(noise_field(noise, 256, 256, 300.0, 2))), kSpectrum).mean;
    }
    EXPECT_GT(mean[1], mean[0] + 0.5);
    // Twice the height changes nothing of it.
    const auto spectrum = [](double height) {
        return of(analysis_of(hills(height, 9, 128, 128)), kSpectrum).mean;
    };
    EXPECT_NEAR(spectrum(200.0), spectrum(400.0), 1e-3);
}

TEST(Quantities, CurvatureOfABowl) {
    // A sphere's mean curvature is 1 / r everywhere.
    constexpr double kRadius = 9000.0;
    Field<float> bowl(96, 96);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const double r = 30.0 * std::hypot(x - 47.5, y - 47.5);
            bowl(x, y) = float(kRadius - std::sqrt(kRadius * kRadius - r * r));
        }
    const Statistics s = of(analysis_of(land(std::move(bowl))), kCurvature);
    EXPECT_NEAR(s.mean, std::asinh(30.0 / kRadius / 0.01), 0.01);
    EXPECT_LT(s.deviation, 0.02);
}

TEST(Quantities, DensityIsTheShareOfSamples) {
    Field<float> waves(128, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            waves(x, y) = float(80.0 * std::sin(x * M_PI / 8.0));
    // A ridge and a valley every 16 samples.
    const Analysis analysis = analysis_of(land(std::move(waves)));
    EXPECT_NEAR(of(analysis, kRidgeDensity).mean, 100.0 / 16.0, 1.0);
    EXPECT_NEAR(of(analysis, kValleyDensity).mean, 100.0 / 16.0, 1.0);
}

TEST(Regions, ThreadsDoNotMatter) {
    const auto made = [] {
        return analyses_of(hills(300.0, 8, 200, 160), halves(200, 160), 2);
    };
    std::vector<Analysis> one;
    {
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        one = made();
    }
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    const std::vector<Analysis> more = made();
    for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t q = 0; q < one[r].size(); ++q) {
            EXPECT_EQ(one[r][q].count, more[r][q].count);
            EXPECT_EQ(one[r][q].mean, more[r][q].mean);
            EXPECT_EQ(one[r][q].kurtosis, more[r][q].kurtosis);
        }
}

}  // namespace
}  // namespace cydonia::statistics
