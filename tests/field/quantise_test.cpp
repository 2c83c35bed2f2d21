#include "field/quantise.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cydonia;

TEST(Quantise, HeightsComeBackWithinHalfALevel) {
    Field<float> heights(7, 5);
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = 812.5f * std::sin(0.7f * static_cast<float>(i));
    const Heights16 h = quantised(heights);
    const Field<float> back = heights_of(h);
    for (std::size_t i = 0; i < heights.size(); ++i)
        EXPECT_NEAR(back[i], heights[i], 0.5 * h.range / 65535.0 + 1e-3);
}

TEST(Quantise, FlatLandHasARange) {
    const Heights16 h = quantised(Field<float>(3, 3, 42.0f));
    EXPECT_GT(h.range, 0.0);
    EXPECT_FLOAT_EQ(heights_of(h)(1, 1), 42.0f);
}
