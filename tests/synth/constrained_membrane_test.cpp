#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synth/pareidolia/constrained/membrane.h"
#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

// Minus the five-point Laplacian, with free borders.
Field<double> laplacian(const Field<double>& c) {
    Field<double> out(c.width(), c.height());
    for (int y = 0; y < c.height(); ++y)
        for (int x = 0; x < c.width(); ++x)
            for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
                if (c.contains(x + dx, y + dy)) out(x, y) += c(x, y) - c(x + dx, y + dy);
    return out;
}

// The greatest share of the force that (bend L^2 + slope L + keep + pull) c is away from
// it, without the last `border` rows and columns.
double residual(int width, int height, const Stiffness& stiffness, double pull,
                int border) {
    const Field<float> force = random_field(width, height, 9);
    Field<float> change = force;
    Membrane(width, height, stiffness, pull).solve(change);
    EXPECT_EQ(change.width(), width);
    EXPECT_EQ(change.height(), height);
    Field<double> c(width, height);
    std::copy(change.begin(), change.end(), c.begin());
    const Field<double> once = laplacian(c), twice = laplacian(once);
    double worst = 0.0;
    for (int y = 0; y < height - border; ++y)
        for (int x = 0; x < width - border; ++x)
            worst = std::max(
                worst,
                std::abs(stiffness.bend * twice(x, y) + stiffness.slope * once(x, y) +
                         (stiffness.keep + pull) * c(x, y) - force(x, y)));
    return worst;
}

}  // namespace

TEST(Membrane, SolvesItsSystemUpToTheBorders) {
    for (const auto& [width, height] : {std::pair{64, 48}, {16, 16}, {20, 128}, {2, 2}}) {
        EXPECT_LT(residual(width, height, {1.0, 0.0, 1e-4}, 1.0, 0), 1e-4) << width;
        EXPECT_LT(residual(width, height, {1.0, 0.3, 1e-6}, 2.0, 0), 1e-4) << width;
    }
}

// Of other sizes the transform is longer, and the land goes on beyond the border.
TEST(Membrane, SolvesItsSystemAtOddAndPrimeSizes) {
    for (const auto& [width, height] :
         {std::pair{97, 61}, {61, 97}, {35, 63}, {14, 11}}) {
        EXPECT_LT(residual(width, height, {1.0, 0.0, 1e-4}, 1.0, 1), 1e-4) << width;
        EXPECT_LT(residual(width, height, {1.0, 0.3, 1e-6}, 2.0, 2), 1e-4) << width;
    }
}

TEST(Membrane, NoForceNoChange) {
    Field<float> force(31, 17);
    Membrane(31, 17, {1.0, 0.3, 1e-6}, 1.0).solve(force);
    for (const float c : force) EXPECT_EQ(c, 0.0f);
}

TEST(Membrane, AnEvenForceMovesEverythingAlike) {
    Field<float> force(64, 32, 3.0f);
    Membrane(64, 32, {1.0, 0.3, 0.5}, 1.0).solve(force);
    for (const float c : force) EXPECT_NEAR(c, 2.0f, 1e-5);
}
