#include "field/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cydonia {
namespace {

TEST(GradientNoise, ZeroAtLatticePoints) {
    for (int y = -5; y <= 5; ++y) {
        for (int x = -5; x <= 5; ++x) EXPECT_EQ(gradient_noise(x, y, 7), 0.0);
    }
}

TEST(GradientNoise, RangeAndMean) {
    double lowest = 0.0, highest = 0.0, sum = 0.0;
    const int n = 1000;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const double value = gradient_noise(0.137 * x, 0.137 * y, 3);
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
            sum += value;
        }
    }
    EXPECT_GE(lowest, -1.0);
    EXPECT_LE(highest, 1.0);
    EXPECT_LT(lowest, -0.7);
    EXPECT_GT(highest, 0.7);
    EXPECT_NEAR(sum / (n * n), 0.0, 0.01);
}

TEST(GradientNoise, ContinuousAcrossLatticeLines) {
    for (double y = -2.0; y < 2.0; y += 0.1) {
        EXPECT_NEAR(gradient_noise(1.0 - 1e-9, y, 7), gradient_noise(1.0 + 1e-9, y, 7),
                    1e-7);
    }
}

TEST(GradientNoise, SeedsDiffer) {
    EXPECT_NE(gradient_noise(0.3, 0.6, 1), gradient_noise(0.3, 0.6, 2));
}

TEST(Fbm, OneOctaveIsGradientNoise) {
    NoiseOptions options{.octaves = 0, .grid = 4.0};
    // Algorithm 1 counts octaves inclusively: 0 is a single term, and the values differ
    // from gradient_noise's only by the octave's own seed.
    EXPECT_EQ(noise_at(options, 0.25, 0.5, 9), 0.0);
    EXPECT_NE(noise_at(options, 0.3, 0.6, 9), 0.0);
    options.octaves = 1;
    options.h = 30.0;
    NoiseOptions single{.octaves = 0, .grid = 4.0};
    EXPECT_NEAR(noise_at(options, 0.3, 0.6, 9), noise_at(single, 0.3, 0.6, 9), 1e-8);
}

TEST(Ridged, CrestsWhereNoiseIsZero) {
    // At lattice points every octave's noise is 0, so the signal is offset^2 there.
    const NoiseOptions options{.kind = NoiseOptions::Kind::kRidged,
                               .h = 1.0,
                               .octaves = 0,
                               .grid = 4.0,
                               .offset = 1.1};
    EXPECT_NEAR(noise_at(options, 0.25, 0.75, 9), 1.21, 1e-12);
    EXPECT_LT(noise_at(options, 0.31, 0.68, 9), 1.21);
}

TEST(NoiseField, SameLandAtEveryResolution) {
    const NoiseOptions options;
    const Field<float> coarse = noise_field(options, 64, 48, 100.0, 5);
    const Field<float> fine = noise_field(options, 192, 144, 100.0, 5);
    // Every third sample of the fine grid lies on a coarse cell's centre.
    for (int y = 0; y < coarse.height(); ++y) {
        for (int x = 0; x < coarse.width(); ++x) {
            EXPECT_NEAR(coarse(x, y), fine(3 * x + 1, 3 * y + 1), 1e-4);
        }
    }
}

}  // namespace
}  // namespace cydonia
