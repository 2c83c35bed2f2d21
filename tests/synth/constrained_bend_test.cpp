#include "synth/pareidolia/constrained/bend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

constexpr BendOptions kOptions{.stiffness = {1.0, 0.3, 1e-6}};

}  // namespace

TEST(Bend, WhatNobodyAsksForStays) {
    const Field<float> land = random_field(40, 32, 2, 50.0);
    Bend bend(land, 10.0, 1.0, {}, kOptions);
    bend.run(5);
    EXPECT_EQ(bend.heights(), land);
}

TEST(Bend, ComesToTheHeightsThatAreHeld) {
    const Field<float> land = random_field(64, 48, 2, 5.0);
    Field<float> held(64, 48, std::numeric_limits<float>::quiet_NaN());
    // Two plateaus, up and down.
    for (int y = 10; y < 20; ++y)
        for (int x = 8; x < 20; ++x) {
            held(x, y) = land(x, y) + 30.0f;
            held(x + 30, y + 16) = land(x + 30, y + 16) - 30.0f;
        }
    Bend bend(land, 10.0, 1.0, held, kOptions);
    bend.run(200);
    const Field<float> bent = bend.heights();
    float worst = 0.0f, step = 0.0f;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x + 1 < 64; ++x) {
            if (std::isfinite(held(x, y)))
                worst = std::max(worst, std::abs(bent(x, y) - held(x, y)));
            step = std::max(step, std::abs((bent(x + 1, y) - land(x + 1, y)) -
                                           (bent(x, y) - land(x, y))));
        }
    EXPECT_LT(worst, 0.1f);
    EXPECT_LT(step, 6.0f);  // and the land between goes along
}
