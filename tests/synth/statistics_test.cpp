#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "field/noise.h"
#include "field/random.h"
#include "synth/statistics/edges.h"
#include "synth/statistics/similarity.h"

namespace cydonia::statistics {
namespace {

TEST(Statistics, AreKStatistics) {
    const std::vector<float> values = {1, 2, 3, 4, 5};
    const Statistics s = statistics_of(values);
    EXPECT_EQ(s.count, 5u);
    EXPECT_DOUBLE_EQ(s.mean, 3.0);
    EXPECT_DOUBLE_EQ(s.deviation, std::sqrt(2.0));
    EXPECT_NEAR(s.skewness, 0.0, 1e-12);
    EXPECT_NEAR(s.kurtosis, -1.2, 1e-12);
    // As of (1, 1, 1, 5): m2 = 3, m3 = 6, m4 = 21.
    const Statistics skew = statistics_of(std::vector<float>{1, 1, 1, 5});
    EXPECT_NEAR(skew.skewness, 2.0, 1e-12);
    EXPECT_NEAR(skew.kurtosis, 4.0, 1e-12);
    EXPECT_EQ(statistics_of(std::vector<float>(9, 4.0f)).skewness, 0.0);
    EXPECT_EQ(statistics_of({}).count, 0u);
}

TEST(Statistics, OfAnExponentialDistribution) {
    std::vector<float> values;
    for (std::uint64_t i = 0; i < 200000; ++i)
        values.push_back(float(-std::log(1.0 - unit(hash_of({i})))));
    const Statistics s = statistics_of(values);
    EXPECT_NEAR(s.mean, 1.0, 0.01);
    EXPECT_NEAR(s.deviation, 1.0, 0.02);
    EXPECT_NEAR(s.skewness, 2.0, 0.1);
    EXPECT_NEAR(s.kurtosis, 6.0, 0.8);
}

TEST(Statistics, AddUpInParts) {
    std::vector<float> values;
    std::array<Moments, 3> parts;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        values.push_back(float(900.0 + 40.0 * std::pow(unit(hash_of({i})), 3.0)));
        parts[i % 3].add(values.back(), 908.0);
    }
    const Statistics whole = statistics_of(values),
                     sum = ((parts[0] += parts[1]) += parts[2]).statistics(908.0);
    EXPECT_EQ(sum.count, whole.count);
    EXPECT_NEAR(sum.mean, whole.mean, 1e-9);
    EXPECT_NEAR(sum.deviation, whole.deviation, 1e-9);
    EXPECT_NEAR(sum.skewness, whole.skewness, 1e-9);
    EXPECT_NEAR(sum.kurtosis, whole.kurtosis, 1e-9);
    EXPECT_EQ(Moments().statistics(1.0).count, 0u);
}

// A step that is spread out so far, across the middle, at an angle.
Field<float> step(double deviation, double height, double angle = 0.0) {
    Field<float> land(160, 160);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x) {
            const double across =
                (x - 79.5) * std::cos(angle) + (y - 79.5) * std::sin(angle);
            land(x, y) =
                float(0.5 * height * std::erf(across / (deviation * std::sqrt(2.0))));
        }
    return land;
}

const Feature& longest(const std::vector<Feature>& edges) {
    return *std::ranges::max_element(edges, {}, &Feature::length);
}

// Lindeberg 1998, section 4: t^(1/2) |grad L|^2 of a diffuse step is largest at its own
// t.
TEST(Edges, AreFoundAtTheirOwnScale) {
    constexpr double kSpacing = 30.0;
    for (const double deviation : {2.0, 4.0, 6.0})
        for (const double angle : {0.0, 0.6, 0.25 * M_PI}) {
            const auto edges = edges_of(step(deviation, 900.0, angle), kSpacing);
            ASSERT_FALSE(edges.empty());
            const Feature& edge = longest(edges);
            EXPECT_NEAR(edge.scale / kSpacing, deviation, 0.15 * deviation) << angle;
            EXPECT_GT(edge.length, 0.75 * 160 * kSpacing) << angle;
            EXPECT_LT(edge.length, 1.5 * 160 * kSpacing) << angle;
        }
}

TEST(Edges, AreAsStrongAsTheyAreHigh) {
    const Feature low = longest(edges_of(step(3.0, 200.0), 30.0)),
                  high = longest(edges_of(step(3.0, 600.0), 30.0));
    EXPECT_NEAR(high.strength / low.strength, 3.0, 0.01);
    EXPECT_NEAR(high.scale, low.scale, 0.01);
    EXPECT_TRUE(edges_of(Field<float>(64, 64, 5.0f), 30.0).empty());
}

Terrain hills(double height, std::uint64_t seed, int side = 128) {
    NoiseOptions noise;
    noise.octaves = 6;
    noise.h = 1.0;
    Terrain terrain;
    terrain.heights = noise_field(noise, side, side, height, seed);
    terrain.spacing = 30.0;
    return terrain;
}

Library two_types() {
    std::vector<Type> types = {{"high", {}}, {"low", {}}};
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        types[0].examples.push_back(analysis_of(hills(600.0, seed)));
        types[1].examples.push_back(analysis_of(hills(90.0, seed + 10)));
    }
    return Library(std::move(types));
}

TEST(Similarity, CurvesHoldAllReferences) {
    const Curve curve = curve_of({3.0, 4.0, 8.0});
    EXPECT_DOUBLE_EQ(curve.mean, 5.0);
    EXPECT_DOUBLE_EQ(curve(5.0), 1.0);
    EXPECT_NEAR(curve(8.0), kBaseline, 1e-12);  // the farthest
    EXPECT_GT(curve(4.0), kBaseline);
    EXPECT_LT(curve(30.0), 0.01);
}

// Section VI.2.1: every sample is at least 90 % like its own type.
TEST(Similarity, ExamplesAreLikeTheirOwnType) {
    const Library library = two_types();
    for (std::size_t t : {0u, 1u})
        for (const Analysis& example : library.types()[t].examples) {
            EXPECT_GE(library.similarity(t, example), kBaseline);
            EXPECT_LT(library.similarity(1 - t, example), 0.5);
        }
    const Analysis other = analysis_of(hills(560.0, 77));
    EXPECT_GT(library.similarity(0, other), library.similarity(1, other) + 0.2);
}

// A steep sample among flat ones makes agreements fall (section VI.2.1).
TEST(Similarity, AStrangerSpoilsTheAgreement) {
    const Library library = two_types();
    const double before = library.agreement(1, Quantity::kSlope);
    EXPECT_GT(before, 0.8);
    EXPECT_LT(
        library.with(1, analysis_of(hills(600.0, 5))).agreement(1, Quantity::kSlope),
        0.6 * before);
    EXPECT_GT(library.with(1, analysis_of(hills(90.0, 5))).agreement(1, Quantity::kSlope),
              0.9 * before);
}

// What does not tell counts for little: of types that differ in elevation only the mean.
TEST(Similarity, OneExampleBorrowsItsTolerance) {
    std::vector<Type> types = two_types().types();
    types.push_back({"one", {analysis_of(hills(250.0, 40))}});
    const Library library(types);
    EXPECT_DOUBLE_EQ(library.similarity(2, library.types()[2].examples[0]), 1.0);
    const double near = library.similarity(2, analysis_of(hills(260.0, 41)));
    EXPECT_GT(near, 0.3);
    EXPECT_LT(near, 1.0);
    EXPECT_GT(near, library.similarity(2, analysis_of(hills(600.0, 42))));
    // Alone in a library nothing tells what is far; it is like itself all the same.
    const Library alone(std::vector<Type>{{"one", {analysis_of(hills(250.0, 40))}}});
    EXPECT_DOUBLE_EQ(alone.similarity(0, alone.types()[0].examples[0]), 1.0);
    const Library empty(std::vector<Type>{{"none", {}}});
    EXPECT_EQ(empty.similarity(0, types[0].examples[0]), 0.0);
}

TEST(Analysis, ThreadsDoNotMatter) {
    const auto made = [] { return analysis_of(hills(300.0, 8)); };
    Analysis one;
    {
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        one = made();
    }
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    const Analysis more = made();
    for (std::size_t q = 0; q < one.size(); ++q) {
        EXPECT_EQ(one[q].count, more[q].count);
        EXPECT_EQ(one[q].mean, more[q].mean);
        EXPECT_EQ(one[q].kurtosis, more[q].kurtosis);
    }
}

TEST(Analysis, CoarserLevelsAreMeans) {
    Terrain ramp;
    ramp.spacing = 10.0;
    ramp.heights = Field<float>(90, 60);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 90; ++x) ramp.heights(x, y) = float(x);
    const Terrain coarse = at_level(ramp, 30.0);
    EXPECT_EQ(coarse.heights.width(), 30);
    EXPECT_EQ(coarse.heights.height(), 20);
    EXPECT_NEAR(coarse.heights(10, 5), 31.0, 1e-3);
    const Analysis analysis = analysis_of(coarse);
    EXPECT_NEAR(analysis[1].mean, degrees(std::atan(0.1)), 1.0);
}

}  // namespace
}  // namespace cydonia::statistics
