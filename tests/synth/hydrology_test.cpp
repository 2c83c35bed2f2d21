#include "synth/hydrology/breach.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "synth/hydrology/depressions.h"

namespace cydonia::hydrology {
namespace {

constexpr double kSpacing = 10.0;

template <class Height>
Field<float> land(int width, int height, const Height& at) {
    Field<float> heights(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) heights(x, y) = static_cast<float>(at(x, y));
    return heights;
}

// A bowl 8 m deep in a plain, its middle at (20, 20).
double bowl(int x, int y) { return std::min(8.0, 0.05 * std::hypot(x - 20, y - 20)); }

// Rough land that falls to the west, with pits everywhere.
Field<float> rough(int width, int height) {
    return land(width, height, [](int x, int y) {
        const auto noise = static_cast<unsigned>(x * 7919 + y * 104729) * 2654435761u;
        return 0.3 * x + 2.0 * std::sin(0.4 * x) * std::sin(0.3 * y) +
               static_cast<double>(noise >> 16) / 65536.0;
    });
}

std::set<std::int32_t> minima(const Field<float>& heights) {
    const auto found = minima_of(heights);
    return {found.begin(), found.end()};
}

}  // namespace

TEST(Depressions, SlopeHasNone) {
    const auto slope = land(12, 9, [](int x, int y) { return x + 0.1 * y; });
    EXPECT_TRUE(minima_of(slope).empty());
    EXPECT_EQ(pits_per_1000(slope), 0.0);
    EXPECT_EQ(depressions_of(slope).count, 0);
    EXPECT_EQ(std::ranges::max(depressions_of(slope).mask), 0.0f);
}

TEST(Depressions, FlatLandDrainsAtItsEdge) {
    EXPECT_EQ(depressions_of(Field<float>(12, 9, 5.0f)).count, 0);
}

TEST(Depressions, TooSmallToHoldWater) {
    for (const int side : {0, 1, 2}) {
        const Field<float> small(side, side, 1.0f);
        EXPECT_EQ(depressions_of(small).count, 0);
        EXPECT_EQ(pits_per_1000(small), 0.0);
    }
}

TEST(Depressions, BowlRunsOverAtItsNotch) {
    auto heights = land(41, 41, bowl);
    const double rim = heights(0, 20);
    EXPECT_EQ(depressions_of(heights).deepest, rim);
    for (int x = 25; x < 41; ++x) heights(x, 20) = 0.25f;
    const Depressions found = depressions_of(heights);
    EXPECT_EQ(found.count, 1);
    EXPECT_EQ(found.deepest, 0.25f);
    for (int y = 0; y < 41; ++y)
        for (int x = 0; x < 41; ++x)
            EXPECT_EQ(found.mask(x, y), std::hypot(x - 20, y - 20) < 5.0 ? 1.0f : 0.0f);
}

TEST(Depressions, PoolsOfOneLakeAreOne) {
    auto heights = Field<float>(20, 9, 10.0f);
    heights(5, 4) = 2.0f;  // three pools, the middle one highest, under one level
    heights(9, 4) = 6.0f;
    heights(14, 4) = 1.0f;
    for (int x = 5; x <= 14; ++x) heights(x, 4) = std::min(heights(x, 4), 8.0f);
    EXPECT_EQ(minima_of(heights).size(), 3u);
    const Depressions found = depressions_of(heights);
    EXPECT_EQ(found.count, 1);
    EXPECT_EQ(found.deepest, 9.0f);
}

TEST(Depressions, PoolOnASlopeEndsAtItsLip) {
    auto slope = land(20, 9, [](int x, int) { return x; });
    slope(12, 4) = 6.5f;
    const Depressions found = depressions_of(slope);
    EXPECT_EQ(found.count, 1);
    EXPECT_EQ(found.deepest, 4.5f);
    Field<float> mask(20, 9);
    mask(12, 4) = 1.0f;
    EXPECT_EQ(found.mask, mask);
}

TEST(Depressions, PoolThatRunsIntoAnotherIsItsOwn) {
    auto heights = land(30, 9, [](int x, int) { return 0.5 * x; });
    heights(22, 4) = 10.0f;  // under a lip of 10.5 m
    heights(19, 4) = 8.0f;   // under one of 9 m, from where the land falls
    const Depressions found = depressions_of(heights);
    EXPECT_EQ(found.count, 2);
    EXPECT_EQ(found.deepest, 1.0f);
}

TEST(Depressions, FlatBottomIsOneMinimumAndNoPit) {
    auto heights = Field<float>(12, 9, 10.0f);
    for (int x = 3; x < 8; ++x) heights(x, 4) = 3.0f;
    EXPECT_EQ(minima_of(heights).size(), 1u);
    EXPECT_EQ(pits_per_1000(heights), 0.0);
}

TEST(Depressions, PitsAreCountedAmongCellsThatHaveEightNeighbours) {
    auto heights = Field<float>(12, 12, 10.0f);
    heights(3, 3) = heights(8, 8) = heights(0, 5) = 9.0f;
    EXPECT_DOUBLE_EQ(pits_per_1000(heights), 20.0);
}

TEST(Breach, BowlDrainsThroughItsNotch) {
    auto heights = land(41, 41, bowl);
    heights(34, 20) =
        0.3f;  // lower than the rest of the way, beyond it the plain is lower
    for (int x = 35; x < 41; ++x) heights(x, 20) = -1.0f;
    const auto before = heights;
    const Breached done = breach(heights, kSpacing);
    EXPECT_EQ(done.cut, 1);
    EXPECT_EQ(done.left, 0);
    EXPECT_EQ(depressions_of(heights).count, 0);
    EXPECT_LE(heights(34, 20), 0.0f);
    for (int x = 20; x < 34; ++x) EXPECT_LE(heights(x + 1, 20), heights(x, 20)) << x;
    for (int y = 0; y < 41; ++y)
        EXPECT_TRUE(y == 20 || heights(20, y) == before(20, y)) << y;
}

TEST(Breach, ChainOfPits) {
    auto heights = land(60, 9, [](int x, int y) {
        return 20.0 - 0.2 * x + std::abs(y - 4) + (y == 4 && x % 6 == 3 ? -1.5 : 0.0);
    });
    EXPECT_EQ(minima_of(heights).size(), 10u);
    const Breached done = breach(heights, kSpacing);
    EXPECT_EQ(done.left, 0);
    EXPECT_TRUE(minima_of(heights).empty());
    EXPECT_EQ(pits_per_1000(heights), 0.0);
}

TEST(Breach, LandThatDrainsStaysAsItIs) {
    auto heights = land(30, 20, [](int x, int y) { return x + 0.1 * y; });
    const auto before = heights;
    EXPECT_EQ(breach(heights, kSpacing).cut, 0);
    EXPECT_EQ(heights, before);
    Field<float> flat(30, 20, 5.0f);
    EXPECT_EQ(breach(flat, kSpacing).cut, 0);
    EXPECT_EQ(flat, Field<float>(30, 20, 5.0f));
}

TEST(Breach, NoHeightRisesAndNoMinimumAppears) {
    for (const int radius : {1, 2, 4, 32}) {
        auto heights = rough(200, 150);
        const auto before = heights;
        const Breached done = breach(heights, kSpacing, {}, radius);
        const auto old = minima(before);
        EXPECT_EQ(minima(heights).size(), static_cast<std::size_t>(done.left));
        for (const std::int32_t cell : minima(heights)) EXPECT_TRUE(old.contains(cell));
        EXPECT_TRUE(std::ranges::equal(heights, before, std::less_equal{}));
        EXPECT_TRUE(radius < 32 || done.left == 0) << done.left;
        EXPECT_TRUE(radius > 1 || done.left > 0);
    }
}

TEST(Breach, BigBasinIsLeft) {
    auto heights = land(120, 120, [](int x, int y) {
        return std::min(8.0, 0.2 * std::hypot(x - 60, y - 60));
    });
    const auto before = heights;
    const Breached done = breach(heights, kSpacing, {}, 20);
    EXPECT_EQ(done.cut, 0);
    EXPECT_EQ(done.left, 1);
    EXPECT_EQ(heights, before);
}

TEST(Breach, NoChannelDeeperThanACellIsWide) {
    auto heights = Field<float>(21, 21, 100.0f);
    heights(10, 10) = 85.0f;
    EXPECT_EQ(breach(heights, 10.0).left, 1);
    EXPECT_EQ(breach(heights, 20.0).left, 0);
}

TEST(Breach, DeepChannelHasBanks) {
    auto heights = land(41, 41, [](int x, int) { return x == 40 ? 0.0 : 30.0; });
    heights(20, 20) = 2.0f;
    const Breached done = breach(heights, 30.0);
    EXPECT_EQ(done.left, 0);
    EXPECT_NEAR(heights(30, 20), 1.0, 1.1);
    EXPECT_NEAR(heights(30, 21) - heights(30, 20), 18.0, 0.7);
    EXPECT_EQ(heights(30, 22), 30.0f);
}

TEST(Breach, LockedBanksStand) {
    auto heights = land(41, 41, [](int x, int) { return x == 40 ? 0.0 : 30.0; });
    heights(20, 20) = 2.0f;
    Field<std::uint8_t> locked(41, 41);
    locked(30, 21) = 1;
    EXPECT_EQ(breach(heights, 30.0, locked).left, 0);
    EXPECT_EQ(heights(30, 21), 30.0f);
    EXPECT_LT(heights(30, 19), 25.0f);
}

TEST(Breach, LockedCellsKeepTheirHeight) {
    auto heights = rough(120, 100);
    const auto before = heights;
    Field<std::uint8_t> locked(120, 100);
    for (int y = 30; y < 60; ++y)
        for (int x = 40; x < 90; ++x) locked(x, y) = 1;
    const Breached done = breach(heights, kSpacing, locked);
    EXPECT_GT(done.left, 0);
    int changed = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        ASSERT_TRUE(!locked[i] || heights[i] == before[i]) << i;
        changed += heights[i] != before[i];
    }
    EXPECT_GT(changed, 100);
    for (const std::int32_t cell : minima(heights))
        EXPECT_TRUE(minima(before).contains(cell));
}

TEST(Breach, EveryRunGivesTheSameBytes) {
    auto one = rough(300, 200), many = one;
    {
        const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
        breach(one, kSpacing);
    }
    breach(many, kSpacing);
    EXPECT_EQ(one, many);
}

}  // namespace cydonia::hydrology
