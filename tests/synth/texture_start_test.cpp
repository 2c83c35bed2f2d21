#include "synth/texture/start.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "field/files.h"
#include "synth/texture/places.h"
#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

// One exemplar of 22 x 22 cells on the coarsest level: 25 pieces of 4 x 4 cells, and a
// border of one cell.
class Start : public testing::Test {
  protected:
    Start() {
        Options options;
        options.levels = 3;
        options.exemplars = {exemplar_of(files_, "a.tif", rough(176, 176), 30.0)};
        SilentProgress silent;
        database_ = database_of(options, {}, silent);
        top_ = int(database_->levels.size()) - 1;
    }
    Synthesis land(int x, int y, int width, int height) const {
        return started(*database_, {.seed = 5}, {}, {top_, x, y, width, height});
    }

    TemporaryFolder files_;
    std::shared_ptr<const Database> database_;
    int top_ = 0;
};

TEST_F(Start, EveryPieceComesBeforeAnyComesAgainInView) {
    constexpr int kSide = 4;  // cells of a piece
    const Synthesis made = land(0, 0, 20 * kSide, 20 * kSide);
    std::map<std::pair<int, int>, std::vector<std::pair<int, int>>> shown;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) {
            const Spot spot = spot_of(made.places(x * kSide, y * kSide));
            shown[{spot.x, spot.y}].emplace_back(x, y);
        }
    EXPECT_EQ(shown.size(), 25u);
    for (const auto& [piece, blocks] : shown) {
        EXPECT_NEAR(double(blocks.size()), 16.0, 5.0);
        for (std::size_t i = 0; i < blocks.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GE(std::hypot(blocks[i].first - blocks[j].first,
                                     blocks[i].second - blocks[j].second),
                          3.0);
    }
}

TEST_F(Start, PiecesAreWholeAndOverlapNowhere) {
    const Synthesis made = land(0, 0, 30 * 4, 30 * 4);
    std::set<std::pair<int, int>> cells;
    const int cell = 2 << top_;
    for (const Place& place : made.places) {
        const Spot spot = spot_of(place);
        EXPECT_EQ(spot.x % cell, cell / 2);
        cells.insert({spot.x / cell, spot.y / cell});
    }
    EXPECT_EQ(cells.size(), 400u);  // all but a border of one cell
}

TEST_F(Start, AnyWindowIsThePlanes) {
    const Synthesis whole = land(-40, -30, 120, 90), part = land(-17, 8, 30, 20);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x)
            ASSERT_EQ(part.places(x, y), whole.places(x + 23, y + 38));
}

}  // namespace
}  // namespace cydonia::texture
