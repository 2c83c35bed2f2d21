#include "field/cells_inside.h"
#include "synth/pareidolia/constrained/window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field/noise.h"
#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

Field<float> wandering_noise(int width, int height) {
    Field<float> noise =
        noise_field({.h = 0.8, .octaves = 3, .grid = 24.0}, width, height, 1.0, 5);
    for (float& n : noise) n = std::clamp(0.5f + n, 0.0f, 1.0f);
    return noise;
}

// How far from the image a window's outline lies, cells: the least and the greatest.
std::pair<float, float> outline(const Field<std::uint8_t>& window,
                                const Field<std::uint8_t>& target) {
    const Field<float> away = cells_inside(target, false);
    const Field<float> inside = cells_inside(window, true);
    std::pair<float, float> range{1e9f, 0.0f};
    for (std::size_t i = 0; i < window.size(); ++i)
        if (inside[i] == 1.0f)
            range = {std::min(range.first, away[i]), std::max(range.second, away[i])};
    return range;
}

}  // namespace

TEST(CellsInside, AreTheWayOut) {
    const auto mask = box(20, 15, 4, 3, 11, 10);
    const Field<float> inside = cells_inside(mask, true);
    EXPECT_EQ(inside(4, 5), 1.0f);
    EXPECT_EQ(inside(7, 6), 4.0f);
    EXPECT_EQ(inside(3, 5), 0.0f);
    const Field<float> outside = cells_inside(mask, false);
    EXPECT_EQ(outside(7, 6), 0.0f);
    EXPECT_NEAR(outside(14, 13), std::hypot(4.0, 4.0), 1e-5);
}

TEST(Window, HoldsTheImageAndSomeGroundAround) {
    const auto target = box(128, 100, 40, 30, 80, 60);
    const auto window = window_of(target, wandering_noise(128, 100));
    for (std::size_t i = 0; i < target.size(); ++i) EXPECT_LE(target[i], window[i]);
    const auto [least, most] = outline(window, target);
    EXPECT_GE(least, 128 * 0.03);
    EXPECT_LE(most, 128 * 0.14);
}

TEST(Window, ItsBorderWanders) {
    const auto target = box(128, 128, 40, 40, 88, 88);
    const Field<float> even(128, 128, 0.5f);
    const auto [least, most] = outline(window_of(target, even), target);
    EXPECT_LT(most - least, 2.0f);
    const auto [near, far] =
        outline(window_of(target, wandering_noise(128, 128)), target);
    EXPECT_GT(far - near, 4.0f);
}

TEST(Window, GapsBelongToIt) {
    Field<std::uint8_t> target(128, 128);
    draw_box(target, 30, 40, 55, 88);
    draw_box(target, 75, 40, 100, 88);
    const auto window = window_of(target, Field<float>(128, 128, 0.5f));
    for (int x = 30; x < 100; ++x) EXPECT_EQ(window(x, 64), 1) << x;
    EXPECT_EQ(window(5, 64), 0);
    EXPECT_EQ(window(64, 5), 0);
}

TEST(Window, ReachesTheFrameOnlyWhereTheImageIsNear) {
    const auto window =
        window_of(box(64, 64, 48, 20, 64, 40), Field<float>(64, 64, 0.5f));
    EXPECT_EQ(window(63, 18), 1);
    EXPECT_EQ(window(0, 30), 0);
}

TEST(Window, OfNothingIsEmpty) {
    for (const auto w : window_of(Field<std::uint8_t>(40, 30), Field<float>(40, 30)))
        EXPECT_EQ(w, 0);
}

TEST(Window, OfAllShadowIsAll) {
    for (const auto w : window_of(Field<std::uint8_t>(40, 30, 1), Field<float>(40, 30)))
        EXPECT_EQ(w, 1);
}
