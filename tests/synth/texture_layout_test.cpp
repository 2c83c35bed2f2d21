#include "synth/texture/synthesis/layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "field/files.h"
#include "field/random.h"
#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

constexpr int kSide = 4;  // cells of the coarsest level, of a block

// Rough on hills that are a good deal higher, and as wide as blocks.
Field<float> hills(int width, int height) {
    Field<float> land = rough(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            land(x, y) += float(600.0 * std::sin(x / 9.0) * std::sin(y / 11.0));
    return land;
}

class LayoutTest : public testing::Test {
  protected:
    LayoutTest() {
        Options options;
        options.levels = 3;
        options.exemplars = {exemplar_of(files_, "a.tif", hills(320, 280), 30.0)};
        SilentProgress silent;
        database_ = database_of(options, {}, silent);
    }
    Layout layout(int orientations = 1, std::uint64_t seed = 5) const {
        return laid_out(*database_, kSide, orientations, seed);
    }
    float height(const Layout& layout, const Spot& spot) const {
        const Level& level = database_->levels[std::size_t(layout.level)];
        const Sheet& sheet = level.sheets[std::size_t(spot.exemplar)];
        const Spot inside = kept_inside(spot, sheet, layout.level);
        return level.heights[sheet.index(inside.x >> (layout.level + 1),
                                         inside.y >> (layout.level + 1))];
    }
    // Mean step in height over the edges of all blocks, where `land` says what lies in a
    // cell.
    template <class Land>
    double step(const Layout& layout, const Land& land) const {
        double sum = 0.0;
        const int cells = Layout::kAround * layout.side;
        for (int edge = 0; edge < cells; edge += layout.side)
            for (int along = 0; along < cells; ++along)
                sum += std::abs(height(layout, land(edge - 1, along)) -
                                height(layout, land(edge, along))) +
                       std::abs(height(layout, land(along, edge - 1)) -
                                height(layout, land(along, edge)));
        return sum / (2.0 * Layout::kAround * cells);
    }
    Spot uncut(const Layout& layout, int x, int y) const {
        const int bx = (x + layout.side) / layout.side - 1,
                  by = (y + layout.side) / layout.side - 1;
        return layout.land(layout.piece(bx, by), bx, by, layout.level, x, y);
    }

    TemporaryFolder files_;
    std::shared_ptr<const Database> database_;
};

TEST_F(LayoutTest, NeighboursMeetAtLikeHeights) {
    Layout chosen = layout(), hashed = chosen;
    for (int y = 0; y < Layout::kAround; ++y)
        for (int x = 0; x < Layout::kAround; ++x)
            hashed.blocks(x, y) =
                int(hash_of({std::uint64_t(x), std::uint64_t(y)}) % hashed.pieces.size());
    const auto steps = [&](const Layout& of) {
        return step(of, [&](int x, int y) { return uncut(of, x, y); });
    };
    EXPECT_LT(steps(chosen), 0.6 * steps(hashed));
}

TEST_F(LayoutTest, SeamsLieWherePiecesDifferLeast) {
    const Layout cut = layout();
    // Over every seam, wherever it lies, and over the blocks' straight edges instead.
    std::vector<float> straight, sewn;
    const int cells = Layout::kAround * cut.side;
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
            const auto jump = [&](const Spot& here, const Spot& east,
                                  std::vector<float>& jumps) {
                const Spot continued = here.moved({2 << cut.level, 0});
                if (continued != east)
                    jumps.push_back(std::abs(height(cut, continued) - height(cut, east)));
            };
            jump(uncut(cut, x, y), uncut(cut, x + 1, y), straight);
            jump(cut.at(x, y), cut.at(x + 1, y), sewn);
        }
    const auto mean = [](const std::vector<float>& values) {
        return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
    };
    EXPECT_EQ(straight.size(), std::size_t(Layout::kAround * cells));
    EXPECT_LT(mean(sewn), 0.75 * mean(straight));
}

TEST_F(LayoutTest, NothingFollowsAsInTheExemplar) {
    const Layout laid = layout();
    const int width = laid.side * (2 << laid.level);
    for (int y = 0; y < Layout::kAround; ++y)
        for (int x = 0; x < Layout::kAround; ++x) {
            const auto middle = [&](int bx, int by) {
                return laid.pieces[std::size_t(laid.piece(bx, by))];
            };
            const Spot here = middle(x, y), east = middle(x + 1, y),
                       south = middle(x, y + 1);
            EXPECT_GE(std::hypot(east.x - here.x - width, east.y - here.y), width / 2);
            EXPECT_GE(std::hypot(south.x - here.x, south.y - here.y - width), width / 2);
        }
}

TEST_F(LayoutTest, AllLandIsTakenAndNoneTwiceSideBySide) {
    const Layout laid = layout();
    const int width = laid.side * (2 << laid.level);
    double shared = 0.0;
    std::map<std::pair<int, int>, int> taken;
    for (int y = 0; y < Layout::kAround; ++y)
        for (int x = 0; x < Layout::kAround; ++x) {
            const Spot here = laid.pieces[std::size_t(laid.piece(x, y))];
            const int cell = 2 << laid.level;
            for (int v = -laid.side / 2; v < laid.side / 2; ++v)
                for (int u = -laid.side / 2; u < laid.side / 2; ++u)
                    ++taken[{here.x / cell + u, here.y / cell + v}];
            const Spot east = laid.pieces[std::size_t(laid.piece(x + 1, y))];
            shared += std::max(0.0, 1.0 - std::abs(east.x - here.x) / double(width)) *
                      std::max(0.0, 1.0 - std::abs(east.y - here.y) / double(width));
        }
    EXPECT_LT(shared / (Layout::kAround * Layout::kAround), 0.05);
    // 320 x 280 cells of level 0 less a border of 8.
    const int scale = 1 << laid.level;
    EXPECT_GT(int(taken.size()), 0.98 * ((320 - 16) / scale * ((280 - 16) / scale)));
}

TEST_F(LayoutTest, SeedsLayDifferentLands) {
    int same = 0;
    const Layout one = layout(1, 5), other = layout(1, 6);
    for (std::size_t i = 0; i < one.blocks.size(); ++i)
        same += one.blocks[i] == other.blocks[i];
    EXPECT_LT(same, int(one.blocks.size()) / 8);
}

TEST_F(LayoutTest, TurnsOnlyAsAllowed) {
    const auto turns = [&](int orientations) {
        std::set<int> found;
        for (const Spot& piece : layout(orientations).pieces)
            found.insert(piece.orientation);
        return found;
    };
    EXPECT_EQ(turns(1), (std::set<int>{0}));
    EXPECT_EQ(turns(2), (std::set<int>{0, 2}));
    EXPECT_EQ(turns(4), (std::set<int>{0, 1, 2, 3}));
    EXPECT_EQ(turns(8).size(), 8u);
}

}  // namespace
}  // namespace cydonia::texture
