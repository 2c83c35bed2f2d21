#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synth/pareidolia/constrained/contradictions.h"
#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

constexpr double kNorth = 0.0, kWest = 270.0;  // where the suns stand

std::size_t relaxed(const ShadowImage& image) {
    return static_cast<std::size_t>(
        std::count(image.relaxed.begin(), image.relaxed.end(), 1));
}

// What a land shows to a sun in the north or in the west, cell by cell.
Field<std::uint8_t> shown(const Field<float>& heights, double azimuth, double fall) {
    Field<std::uint8_t> shadow(heights.width(), heights.height());
    const bool north = azimuth == kNorth;
    for (int row = 0; row < (north ? heights.width() : heights.height()); ++row) {
        double light = -1e9;
        for (int i = 0; i < (north ? heights.height() : heights.width()); ++i) {
            const int x = north ? row : i, y = north ? i : row;
            shadow(x, y) = heights(x, y) < light;
            light = std::max<double>(light, heights(x, y)) - fall;
        }
    }
    return shadow;
}

Field<std::uint8_t> random_mask(int width, int height, std::uint64_t seed) {
    Field<std::uint8_t> mask(width, height);
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = hash_of({seed, i}) % 3 == 0;
    return mask;
}

}  // namespace

// From the west a = (5, 5) shades b = (6, 5), and b from the north d = (6, 6), while
// c = (5, 6) and d are lit for the other.
TEST(Contradictions, ABlockOfTwoByTwoIsFoundAndHit) {
    std::vector<ShadowImage> images{image_of(box(12, 12, 6, 5, 7, 6), kWest),
                                    image_of(box(12, 12, 6, 6, 7, 7), kNorth)};
    const Contradictions found = settle(images);
    EXPECT_EQ(found.quadruples, 1u);
    EXPECT_EQ(found.least_wrong, 1u);
    EXPECT_EQ(found.relaxed, 1u);
    EXPECT_EQ(relaxed(images[0]) + relaxed(images[1]), 1u);
    // One image without fault, the other with as much shadow too many as it has.
    EXPECT_DOUBLE_EQ(found.bound, (1.0 + 1.0 / 2.0) / 2.0);
    // It is one of the four cells.
    for (const ShadowImage& image : images)
        for (int y = 0; y < 12 && !image.relaxed.empty(); ++y)
            for (int x = 0; x < 12; ++x)
                if (image.relaxed(x, y)) {
                    EXPECT_TRUE(x >= 5 && x <= 6 && y >= 5 && y <= 6);
                }
}

TEST(Contradictions, FartherApartToo) {
    // Casters 3 cells to the west, 2 to the north.
    std::vector<ShadowImage> images{image_of(box(20, 20, 6, 5, 9, 6), kWest),
                                    image_of(box(20, 20, 8, 6, 9, 8), kNorth)};
    const Contradictions found = settle(images);
    EXPECT_GT(found.quadruples, 0u);
    EXPECT_EQ(settle(images).quadruples, 0u);
}

TEST(Contradictions, OutsideAWindowNothingContradicts) {
    std::vector<ShadowImage> images{image_of(box(12, 12, 6, 5, 7, 6), kWest),
                                    image_of(box(12, 12, 6, 6, 7, 7), kNorth)};
    images[0].window = images[0].target;  // its lit cells do not count
    EXPECT_EQ(settle(images).quadruples, 0u);
    EXPECT_TRUE(images[0].relaxed.empty());
    EXPECT_TRUE(images[1].relaxed.empty());
}

TEST(Contradictions, WindowsSideBySideHaveNone) {
    std::vector<ShadowImage> images{image_of(box(64, 64, 8, 8, 24, 24), kWest),
                                    image_of(box(64, 64, 40, 8, 56, 24), kNorth)};
    images[0].window = box(64, 64, 4, 4, 30, 28);
    images[1].window = box(64, 64, 31, 4, 62, 30);
    const Contradictions found = settle(images);
    EXPECT_EQ(found.quadruples, 0u);
    EXPECT_EQ(found.bound, 1.0);
}

TEST(Contradictions, WhatALandShowsIsNone) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Field<float> land = random_field(24, 19, seed, 3.0);
        std::vector<ShadowImage> images{image_of(shown(land, kWest, 1.0), kWest),
                                        image_of(shown(land, kNorth, 0.7), kNorth)};
        ASSERT_EQ(settle(images).quadruples, 0u) << "seed " << seed;
    }
}

TEST(Contradictions, NoneIsLeft) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        std::vector<ShadowImage> images{image_of(random_mask(30, 22, seed), kWest),
                                        image_of(random_mask(30, 22, seed + 100), kNorth),
                                        image_of(random_mask(30, 22, seed + 200), 125.0)};
        const Contradictions found = settle(images);
        EXPECT_GT(found.quadruples, found.least_wrong);
        EXPECT_GE(found.relaxed, found.least_wrong);
        EXPECT_EQ(found.relaxed,
                  relaxed(images[0]) + relaxed(images[1]) + relaxed(images[2]));
        EXPECT_EQ(settle(images).quadruples, 0u) << "seed " << seed;
    }
}

TEST(Contradictions, TheBoundCountsLeastWrongCellsToTheImageWithMostShadow) {
    std::vector<ShadowImage> images{image_of(random_mask(30, 22, 1), kWest),
                                    image_of(random_mask(30, 22, 2), kNorth)};
    const auto shadow = [](const ShadowImage& image) {
        return static_cast<double>(
            std::count(image.target.begin(), image.target.end(), 1));
    };
    const double most = std::max(shadow(images[0]), shadow(images[1]));
    const Contradictions found = settle(images);
    EXPECT_NEAR(found.bound,
                0.5 + 0.5 * most / (most + static_cast<double>(found.least_wrong)),
                1e-12);
    EXPECT_LT(found.bound, 1.0);
}

TEST(Contradictions, OneImageHasNone) {
    std::vector<ShadowImage> images{image_of(random_mask(30, 22, 1), kWest)};
    const Contradictions found = settle(images);
    EXPECT_EQ(found.quadruples, 0u);
    EXPECT_EQ(found.bound, 1.0);
}
