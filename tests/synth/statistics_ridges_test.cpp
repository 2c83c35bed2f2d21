#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field/noise.h"
#include "synth/statistics/ridges.h"

namespace cydonia::statistics {
namespace {

constexpr double kSpacing = 30.0;
constexpr int kSide = 160;

// A ridge whose section is a Gaussian curve, across the middle, at an angle.
Field<float> ridge(double deviation, double height, double angle = 0.0) {
    Field<float> land(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double across =
                (x - 79.5) * std::cos(angle) + (y - 79.5) * std::sin(angle);
            land(x, y) = float(
                height * std::exp(-0.5 * across * across / (deviation * deviation)));
        }
    return land;
}

Field<float> dome(double deviation, double height) {
    Field<float> land(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double r = std::hypot(x - 70.0, y - 90.0);
            land(x, y) = float(height * std::exp(-0.5 * r * r / (deviation * deviation)));
        }
    return land;
}

Field<float> negative(Field<float> land) {
    for (float& height : land) height = -height;
    return land;
}

const Feature& longest(const std::vector<Feature>& features) {
    return *std::ranges::max_element(features, {}, &Feature::length);
}

// Lindeberg 1998, section 5: with gamma 3/4 a Gaussian ridge is found at its own t.
TEST(Ridges, AreFoundAtTheirOwnScale) {
    for (const double deviation : {2.0, 4.0, 6.0})
        for (const double angle : {0.0, 0.6, 0.25 * M_PI}) {
            const auto found = ridges_of(ridge(deviation, 300.0, angle), kSpacing);
            ASSERT_FALSE(found.ridges.empty());
            const Feature& line = longest(found.ridges);
            EXPECT_NEAR(line.scale / kSpacing, deviation, 0.15 * deviation) << angle;
            EXPECT_GT(line.length, 0.75 * kSide * kSpacing) << angle;
            EXPECT_LT(line.length, 1.5 * kSide * kSpacing) << angle;
            // On the crest, to the sample; land mirrored at the sides bends it there.
            for (const std::uint32_t i : line.samples) {
                const double x = i % kSide - 79.5, y = i / kSide - 79.5;
                if (std::max(std::abs(x), std::abs(y)) > 79.5 - 3.0 * deviation) continue;
                EXPECT_LT(std::abs(x * std::cos(angle) + y * std::sin(angle)), 1.3);
            }
        }
}

TEST(Ridges, AreValleysUpsideDown) {
    const Field<float> land = ridge(3.0, 300.0, 0.3);
    const Ridges up = ridges_of(land, kSpacing),
                 down = ridges_of(negative(land), kSpacing);
    ASSERT_EQ(up.ridges.size(), down.valleys.size());
    EXPECT_EQ(longest(up.ridges).samples, longest(down.valleys).samples);
    EXPECT_EQ(longest(up.ridges).strength, longest(down.valleys).strength);
}

TEST(Ridges, AreAsStrongAsTheyAreHigh) {
    const Ridges low = ridges_of(ridge(3.0, 100.0), kSpacing),
                 high = ridges_of(ridge(3.0, 300.0), kSpacing);
    EXPECT_NEAR(longest(high.ridges).strength / longest(low.ridges).strength, 3.0, 0.01);
}

TEST(Ridges, PlanesHaveNone) {
    Field<float> plane(96, 96);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) plane(x, y) = float(9 * x - 4 * y);
    for (const Field<float>& land :
         {plane, Field<float>(96, 96, 5.0f), Field<float>(3, 2), Field<float>(1, 1)}) {
        const Ridges none = ridges_of(land, kSpacing);
        EXPECT_TRUE(none.ridges.empty());
        EXPECT_TRUE(none.valleys.empty());
        EXPECT_TRUE(none.peaks.empty());
    }
}

// Lindeberg 1998, section 7: t^2 det H of a Gaussian dome is largest at its own t.
TEST(Peaks, AreFoundAtTheirOwnScale) {
    for (const double deviation : {2.0, 4.0, 6.0}) {
        const Ridges found = ridges_of(dome(deviation, 300.0), kSpacing);
        ASSERT_EQ(found.peaks.size(), 1u);
        EXPECT_NEAR(found.peaks[0].scale / kSpacing, deviation, 0.15 * deviation);
        EXPECT_EQ(found.peaks[0].samples[0], 90u * kSide + 70u);
        EXPECT_TRUE(ridges_of(negative(dome(deviation, 300.0)), kSpacing).peaks.empty());
    }
}

}  // namespace
}  // namespace cydonia::statistics
