#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "synth/detail/example.h"
#include "synth/detail/window.h"

namespace cydonia::detail {

// A level's whole coarse land in blocks: in rows, each `step` cells from the one before
// it and `overlap` wider, so that so many cells are both's.
struct Blocks {
    int width = 0, height = 0;  // of the land, cells
    int step = 1, overlap = 0;

    int side() const { return step + overlap; }
    int across() const { return count(width); }
    int down() const { return count(height); }
    // The one that a cell lies in, among them row by row; the first of two.
    int at(int x, int y) const {
        return std::min(y / step, down() - 1) * across() +
               std::min(x / step, across() - 1);
    }

  private:
    int count(int cells) const {
        return cells <= side() ? 1 : (cells - overlap + step - 1) / step;
    }
};

// Blocks of so many cells a side, a quarter of it shared with each neighbour.
Blocks blocks_of(int width, int height, int side);

// What a block's details are taken from: from the land's coarse cell to the example's.
struct Match {
    int example = -1;  // none
    int dx = 0, dy = 0;
    bool operator==(const Match&) const = default;
};

// Where a level's blocks find theirs.
struct Searching {
    Search search;
    int candidates;
    int level;  // of the land
    std::uint64_t seed;
};

// For each block of the whole that lies in `land`, a window of it, row by row, the part
// of an example whose coarse land is most like the block's, up to the height of both: the
// least sum of squared differences after their means are taken away (Brosz 2007,
// section 5.2). `before`: the blocks' matches one level coarser, tried too; may be empty.
// Other blocks, and those that are not `wanted`, have no match. Throws bad_request: no
// example is large enough for a block.
std::vector<Match> matched(const Field<float>& land, const Window& window,
                           const Blocks& blocks, std::span<const Example> examples,
                           const Searching& searching, const Blocks& blocks_before,
                           std::span<const Match> before,
                           const std::function<bool(int block)>& wanted);

}  // namespace cydonia::detail
