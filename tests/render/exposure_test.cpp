#include "render/colour/exposure.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cydonia::render {
namespace {

// Nine tenths at `light`, the rest far brighter.
Field<Rgb> lit(float light) {
    Field<Rgb> frame(100, 10, {light, light, light});
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 8; ++x) frame(x, y) = {50.0f, 50.0f, 50.0f};
    return frame;
}

TEST(OwnStops, BringNineTenthsUnderTheirWhite) {
    EXPECT_NEAR(own_stops(lit(0.5f)), 0.0, 1e-5);
    EXPECT_NEAR(own_stops(lit(0.125f)), 2.0, 1e-5);
    EXPECT_NEAR(own_stops(lit(2.0f)), -2.0, 1e-5);
}

TEST(OwnStops, StayWithinSix) {
    EXPECT_EQ(own_stops(lit(1e-6f)), 6.0);
    EXPECT_EQ(own_stops(lit(1e6f)), -6.0);
    EXPECT_EQ(own_stops(Field<Rgb>(9, 9)), 0.0);
}

TEST(SteadyStops, AreTheMiddleOnesInAnyOrder) {
    EXPECT_EQ(steady_stops({1.5}), 1.5);
    EXPECT_EQ(steady_stops({3.0, 1.0, 2.0}), 2.0);
    std::vector<double> own{0.9, 1.0, 1.1, 1.05, 0.95};
    const double steady = steady_stops(own);
    std::ranges::reverse(own);
    EXPECT_EQ(steady_stops(own), steady);
}

// The sun comes over a ridge for two frames of fifty: the others stay as they were.
TEST(SteadyStops, AFewFramesDoNotMoveThem) {
    std::vector<double> own(48, 1.0);
    own.insert(own.end(), {-5.0, -6.0});
    EXPECT_EQ(steady_stops(own), 1.0);
}

}  // namespace
}  // namespace cydonia::render
