#include "synth/texture/constraints/pull.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cydonia::texture {
namespace {

constexpr double kS = 0.5, kLambda = 0.5;

double at(double x, double d) { return phi(x, d, kS, kLambda); }
double slope(double x, double d) { return (at(x + 1e-5, d) - at(x - 1e-5, d)) / 2e-5; }

TEST(TexturePull, PhiIsSmoothWhereItsPartsMeet) {
    for (double d : {0.1, 1.0, 40.0, 1000.0}) {
        const double t = kS * d;
        EXPECT_NEAR(at(t * (1 - 1e-9), d), at(t * (1 + 1e-9), d), 1e-6 * t);
        EXPECT_NEAR(slope(0.0, d), 0.0, 1e-6);
        EXPECT_NEAR(slope(0.999 * t, d), kLambda, 2e-3);
        EXPECT_NEAR(slope(1.001 * t, d), kLambda, 1e-6);
        // b and c as they are printed in eq. 8.
        const double b = -kLambda / (3 * t * t), c = b * t * t * t + kLambda * t;
        EXPECT_NEAR(at(0.7 * t, d), -b * std::pow(0.7 * t, 3), 1e-9 * t);
        EXPECT_NEAR(at(3.0 * t, d), kLambda * 3.0 * t - c, 1e-9 * t);
    }
}

TEST(TexturePull, PhiIsTheSameUpAndDown) {
    for (double x : {0.0, 3.0, 20.0, 900.0}) EXPECT_EQ(at(-x, 40.0), -at(x, 40.0));
}

TEST(TexturePull, OnTheConstraintPhiIsItsLimit) {
    EXPECT_EQ(at(0.0, 0.0), 0.0);
    EXPECT_EQ(at(80.0, 0.0), kLambda * 80.0);
    EXPECT_NEAR(at(80.0, 1e-6), at(80.0, 0.0), 1e-6);
    EXPECT_EQ(blended(10.0f, {90.0f, 0.0f, 100.0f}, kS, kLambda), 50.0f);
}

TEST(TexturePull, FreeCellsStay) {
    EXPECT_EQ(blended(10.0f, {}, kS, kLambda), 10.0f);
    EXPECT_EQ(blended(10.0f, {500.0f, 100.0f, 100.0f}, kS, kLambda), 10.0f);
}

TEST(TexturePull, InfluenceFadesWithoutACliff) {
    float before = blended(0.0f, {500.0f, 0.0f, 100.0f}, kS, kLambda);
    for (float d = 1.0f; d <= 101.0f; d += 1.0f) {
        const float height = blended(0.0f, {500.0f, d, 100.0f}, kS, kLambda);
        EXPECT_LE(height, before);
        EXPECT_GT(height, before - 8.0f) << d;  // of 250 m in 100 steps
        before = height;
    }
    EXPECT_EQ(before, 0.0f);
}

}  // namespace
}  // namespace cydonia::texture
