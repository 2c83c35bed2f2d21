#include "synth/pareidolia/region_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

// '#' is shadow.
Field<std::uint8_t> drawn(const std::vector<std::string>& rows) {
    Field<std::uint8_t> image(static_cast<int>(rows[0].size()),
                              static_cast<int>(rows.size()));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) image(x, y) = rows[y][x] == '#';
    return image;
}

std::vector<int> depths(const RegionTree& tree) {
    std::vector<int> result;
    for (const auto& region : tree.regions) result.push_back(region.depth);
    return result;
}

}  // namespace

TEST(RegionTree, TheSmileyIsFigure5_9) {
    const RegionTree tree = region_tree(drawn({
        "...........",
        ".#########.",
        ".##.###.##.",  // eyes
        ".##.###.##.",
        ".#########.",
        ".##.....##.",  // mouth
        ".#########.",
        "...........",
    }));
    EXPECT_EQ(depths(tree), (std::vector<int>{0, 1, 2, 2, 2}));
    const int head = tree.region_at(1, 1);
    EXPECT_EQ(tree.regions[head].parent, RegionTree::kBackground);
    for (const auto& [x, y] : {std::pair{3, 2}, {7, 3}, {5, 5}})
        EXPECT_EQ(tree.regions[tree.region_at(x, y)].parent, head) << x << "," << y;
    EXPECT_NE(tree.region_at(3, 2), tree.region_at(7, 2));
    EXPECT_EQ(tree.region_at(0, 0), tree.region_at(10, 7));
}

TEST(RegionTree, RingsWithinRingsAreAsDeepAsTheyAreMany) {
    const int side = 33;
    Field<std::uint8_t> image(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            image(x, y) = std::max(std::abs(x - 16), std::abs(y - 16)) % 4 < 2;

    const RegionTree tree = region_tree(image);
    std::vector<int> chain;
    for (int r = tree.region_at(16, 16); r >= 0; r = tree.regions[r].parent)
        chain.push_back(tree.regions[r].depth);
    EXPECT_EQ(chain, (std::vector<int>{9, 8, 7, 6, 5, 4, 3, 2, 1, 0}));
    for (std::size_t i = 0; i < image.size(); ++i)
        EXPECT_EQ(tree.depth_at(i) % 2, image[i]);
}

TEST(RegionTree, LightThatTouchesTheFrameIsBackground) {
    const RegionTree tree = region_tree(drawn({
        ".#.#.",
        ".#.#.",
        ".###.",
        ".....",
    }));
    EXPECT_EQ(depths(tree), (std::vector<int>{0, 1}));
    EXPECT_EQ(tree.region_at(2, 0), RegionTree::kBackground);
}

TEST(RegionTree, AHoleInAShadowThatFillsTheFrame) {
    const RegionTree tree = region_tree(drawn({
        "####",
        "#..#",
        "####",
    }));
    EXPECT_EQ(depths(tree), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(tree.region_at(1, 1), 2);
}

TEST(RegionTree, ShadowHoldsTogetherByCornersAndLightDoesNot) {
    const RegionTree tree = region_tree(drawn({
        ".....",
        "..#..",
        ".#.#.",
        "..#..",
        ".....",
    }));
    EXPECT_EQ(depths(tree), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(tree.region_at(2, 2), 2);
}

TEST(RegionTree, NothingButLightOrShadow) {
    EXPECT_EQ(depths(region_tree(Field<std::uint8_t>(5, 4))), (std::vector<int>{0}));
    EXPECT_EQ(depths(region_tree(Field<std::uint8_t>(5, 4, 1))),
              (std::vector<int>{0, 1}));
    EXPECT_EQ(depths(region_tree(Field<std::uint8_t>(1, 1, 1))),
              (std::vector<int>{0, 1}));
}
