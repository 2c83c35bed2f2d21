#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/texture/synthesis/origins.h"

namespace cydonia::texture {

// The land of the exemplars from which each part of the plane starts: a patchwork of
// pieces, one for each block, that repeats after kAround blocks each way.
struct Layout {
    static constexpr int kAround = 32;

    std::vector<Spot> pieces;  // the pieces' centres on the exemplars; pieces overlap
    Field<int> blocks;         // kAround x kAround indices in `pieces`

    // Blocks are `side` cells of `level` wide. `west` tells for each row of a block how
    // many cells east of its west edge the seam lies, `north` for each column how many
    // cells south of its north edge.
    int level = 0, side = 0;
    std::vector<std::int8_t> west, north;

    int piece(int block_x, int block_y) const {
        return blocks(block_x & (kAround - 1), block_y & (kAround - 1));
    }
    // The position on the exemplar of cell (x, y) of a level, if `piece` lies on the
    // block. The cell may lie outside the block and the position outside the exemplar.
    Spot land(int piece, int block_x, int block_y, int at_level, int x, int y) const;
    // The position on the exemplar of cell (x, y) of `level`, with seams.
    Spot at(int x, int y) const;
};

// A patchwork (Efros and Freeman 2001) of pieces, which are `side` cells of the coarsest
// level wide. Neighbouring pieces are similar in height and roughness where they meet, so
// that plains continue as plains and ranges as ranges. They do not follow each other in
// the exemplar, so that no large copy of it appears. All pieces are used about equally
// often, and the same land is kept far apart. The seam between two pieces lies where they
// differ least.
Layout laid_out(const Database& database, int side, int orientations, std::uint64_t seed);

}  // namespace cydonia::texture
