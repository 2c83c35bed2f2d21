#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "synth/detail/example.h"
#include "synth/detail/window.h"

namespace cydonia::detail {

// The division of a level's whole coarse land into blocks, in rows. Each begins `step`
// cells after the one before it and shares `overlap` cells with the next.
struct Blocks {
    int width = 0, height = 0;  // the land's level, cells
    int step = 1, overlap = 0;

    int side() const { return step + overlap; }
    int across() const { return count(width); }
    int down() const { return count(height); }
    // The block that contains a cell, counted row by row; the first if there are two.
    int at(int x, int y) const {
        return std::min(y / step, down() - 1) * across() +
               std::min(x / step, across() - 1);
    }

  private:
    int count(int cells) const {
        return cells <= side() ? 1 : (cells - overlap + step - 1) / step;
    }
};

// Blocks of `side` cells a side that share a quarter of it with each neighbour.
Blocks blocks_of(int width, int height, int side);

// Where a block's details are taken from: the shift from the land's coarse cells to the
// example's.
struct Match {
    int example = -1;  // -1: none
    int dx = 0, dy = 0;
    bool operator==(const Match&) const = default;
};

// How the matches of a level's blocks are searched for.
struct Searching {
    Search search;
    int candidates;
    int level;  // of the land
    std::uint64_t seed;
};

// The matches of all blocks, row by row. `land` is a window of the whole. The match of a
// block in it is the part of an example whose coarse land is most similar regardless of
// its mean height: the one with the least sum of squared differences after the means are
// subtracted (Brosz 2007, section 5.2). `before` are the matches one level coarser, which
// are tried, too; may be empty. Blocks outside `land` and those that are not `wanted`
// have no match. Throws bad_request if no example is large enough for a block.
std::vector<Match> matched(const Field<float>& land, const Window& window,
                           const Blocks& blocks, std::span<const Example> examples,
                           const Searching& searching, const Blocks& blocks_before,
                           std::span<const Match> before,
                           const std::function<bool(int block)>& wanted);

}  // namespace cydonia::detail
