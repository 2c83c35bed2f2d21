#include "field/enclosed.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cydonia {
namespace {

// '#' is a wall.
std::vector<std::string> enclosed(const std::vector<std::string>& rows) {
    Field<std::uint8_t> walls(static_cast<int>(rows[0].size()),
                              static_cast<int>(rows.size()));
    for (int y = 0; y < walls.height(); ++y)
        for (int x = 0; x < walls.width(); ++x) walls(x, y) = rows[y][x] == '#';
    const Field<std::uint8_t> mask = enclosed_by(walls);
    std::vector<std::string> shown = rows;
    for (int y = 0; y < walls.height(); ++y)
        for (int x = 0; x < walls.width(); ++x)
            if (mask(x, y)) shown[y][x] = 'o';
    return shown;
}

using Rows = std::vector<std::string>;

TEST(EnclosedBy, RingsWithinRings) {
    EXPECT_EQ(enclosed({"#####", "#...#", "#.#.#", "#...#", "#####"}),
              (Rows{"#####", "#ooo#", "#o#o#", "#ooo#", "#####"}));
}

TEST(EnclosedBy, CornersHoldAndGapsDoNot) {
    EXPECT_EQ(enclosed({".#.", "#.#", ".#."}), (Rows{".#.", "#o#", ".#."}));
    EXPECT_EQ(enclosed({"###", "#.#", "#.#"}), (Rows{"###", "#.#", "#.#"}));
}

TEST(EnclosedBy, NothingAndWallsAlone) {
    EXPECT_EQ(enclosed({"...", "..."}), (Rows{"...", "..."}));
    EXPECT_EQ(enclosed({"##", "##"}), (Rows{"##", "##"}));
    EXPECT_TRUE(enclosed_by({}).empty());
}

}  // namespace
}  // namespace cydonia
