#include "synth/texture/database/pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

std::uint8_t type_at(const LevelArrays& level, int x, int y, int exemplar = 0) {
    return level.types[level.sheets[std::size_t(exemplar)].index(x, y)];
}

TEST(Pyramid, HalvesByMeans) {
    const Field<float> heights =
        heights_of(41, 33, [](int x, int y) { return 4.0 * x + 8.0 * y; });
    const auto pyramid = pyramid_of({land_of(heights), land_of(rough(64, 64))}, 3);
    ASSERT_EQ(pyramid.size(), 3u);
    const Sheet& sheet = pyramid[2].sheets[0];
    EXPECT_EQ(sheet.width, 10);
    EXPECT_EQ(sheet.height, 8);
    // The middle of four by four cells.
    EXPECT_EQ(pyramid[2].heights[sheet.index(3, 2)], 4.0f * 13.5f + 8.0f * 9.5f);
}

TEST(Pyramid, GuardRepeatsTheBorder) {
    const Field<float> heights = rough(20, 14);
    const auto level = pyramid_of({land_of(rough(30, 30)), land_of(heights)}, 1)[0];
    const Sheet& sheet = level.sheets[1];
    for (int y = -kGuard; y < 14 + kGuard; ++y)
        for (int x = -kGuard; x < 20 + kGuard; ++x) {
            EXPECT_EQ(level.heights[sheet.index(x, y)],
                      heights(std::clamp(x, 0, 19), std::clamp(y, 0, 13)));
            if (!heights.contains(x, y)) {
                EXPECT_EQ(type_at(level, x, y, 1), kNowhere);
            }
        }
}

TEST(Pyramid, NothingFromBorders) {
    constexpr int kBorders[] = {3, 3, 3, 2, 1, 1};
    const auto pyramid = pyramid_of({land_of(rough(256, 256))}, 6);
    ASSERT_EQ(pyramid.size(), 6u);
    for (std::size_t i = 0; i < pyramid.size(); ++i) {
        const LevelArrays& level = pyramid[i];
        const int side = level.sheets[0].width;
        for (int x = 0; x < side; ++x) {
            const bool border = x < kBorders[i] || x >= side - kBorders[i];
            EXPECT_EQ(type_at(level, x, side / 2) == kNowhere, border) << i << ' ' << x;
            EXPECT_EQ(type_at(level, side / 2, x) == kNowhere, border) << i << ' ' << x;
        }
    }
}

TEST(Pyramid, NothingWithinTwoAndAHalfCellsOfVoids) {
    Land land = land_of(rough(64, 64));
    land.voids = Field<std::uint8_t>(64, 64);
    land.voids(30, 20) = 1;
    const auto pyramid = pyramid_of({land}, 3);
    for (int y = 10; y < 30; ++y)
        for (int x = 20; x < 40; ++x)
            EXPECT_EQ(type_at(pyramid[0], x, y) == kNowhere,
                      std::hypot(x - 30, y - 20) <= 2.5)
                << x << ' ' << y;
    // A quarter of cell (15, 10) of the next level, a sixteenth of the one after.
    EXPECT_EQ(type_at(pyramid[1], 15, 10), kNowhere);
    EXPECT_EQ(type_at(pyramid[1], 15, 13), kNoType);
    EXPECT_EQ(type_at(pyramid[2], 7, 5), kNoType);
}

TEST(Pyramid, TypesByMajorityOfAllCells) {
    Land land = land_of(rough(64, 64));
    // Of each 4x4 square 7 cells of type 2, spread so that no 2x2 square has a majority
    // of them on every step, 6 of type 0, 3 of none.
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const int i = 4 * (y % 4) + x % 4;
            land.types(x, y) = i < 7 ? 2 : i < 13 ? 0 : kNoType;
        }
    const auto pyramid = pyramid_of({land}, 3);
    EXPECT_EQ(type_at(pyramid[0], 16, 16), 2);
    EXPECT_EQ(type_at(pyramid[0], 19, 19), kNoType);
    EXPECT_EQ(type_at(pyramid[2], 5, 5), 2);
    EXPECT_EQ(type_at(pyramid[1], 10, 11), 0);  // cells 8, 9, 12, 13: 0, 0, 0, none
}

TEST(Pyramid, EndsWhereNoLandIsLeft) {
    // 4x4 places on the second level, none on the third.
    EXPECT_EQ(pyramid_of({land_of(rough(20, 20))}, 7).size(), 2u);
    EXPECT_EQ(pyramid_of({land_of(rough(20, 20)), land_of(rough(80, 80))}, 7).size(), 4u);
    EXPECT_EQ(pyramid_of({land_of(rough(11, 11))}, 7).size(), 1u);
    EXPECT_EQ(pyramid_of({land_of(rough(80, 80))}, 2).size(), 2u);
    // One cell wide is never less.
    EXPECT_EQ(pyramid_of({land_of(rough(200, 200)), land_of(rough(11, 11))}, 5)[4]
                  .sheets[1]
                  .width,
              1);
}

TEST(Pyramid, SeedsLieOnLandOfTheirType) {
    Land land = land_of(rough(120, 100));
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 120; ++x)
            land.types(x, y) = x < 100 ? 0 : x < 110 ? 1 : kNoType;
    LevelArrays level = std::move(pyramid_of({land_of(rough(30, 30)), land}, 1)[0]);
    sow(level, 3);
    ASSERT_EQ(level.seeds.size(), 3u);
    EXPECT_EQ(level.seeds[0].size(), std::size_t(kSeeds));
    EXPECT_EQ(level.seeds[1].size(), 10u * 94u);
    EXPECT_TRUE(level.seeds[2].empty());
    int west = 0, north = 0;
    for (std::size_t t = 0; t < 2; ++t) {
        std::set<std::uint64_t> different;
        for (const std::uint64_t seed : level.seeds[t]) {
            EXPECT_EQ(seed >> 48, 1u);
            const int x = int(seed & 0xffffff), y = int(seed >> 24 & 0xffffff);
            EXPECT_EQ(type_at(level, x, y, 1), t);
            different.insert(seed);
            west += t == 0 && x < 52;
            north += t == 0 && y < 50;
        }
        EXPECT_EQ(different.size(), level.seeds[t].size());
    }
    EXPECT_NEAR(west, 0.5 * kSeeds, 80);  // evenly: half of 3..99 lies west of 51.5
    EXPECT_NEAR(north, 0.5 * kSeeds, 80);
}

}  // namespace
}  // namespace cydonia::texture
