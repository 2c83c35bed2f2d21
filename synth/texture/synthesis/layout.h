#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/texture/synthesis/places.h"

namespace cydonia::texture {

// Which land of the exemplars each part of the plane starts from: a patchwork of pieces,
// one a block, that comes again after kAround blocks each way.
struct Layout {
    static constexpr int kAround = 32;

    std::vector<Spot> pieces;  // land to choose from, by its middle; pieces overlap
    Field<int> blocks;         // kAround x kAround, of `pieces`

    // Blocks are `side` cells of this level wide. A seam lies so many cells east of a
    // block's west edge, for each of its rows, and south of its north edge, for each of
    // its columns.
    int level = 0, side = 0;
    std::vector<std::int8_t> west, north;

    int piece(int block_x, int block_y) const {
        return blocks(block_x & (kAround - 1), block_y & (kAround - 1));
    }
    // The land that a piece laid on a block has for cell (x, y) of a level, inside the
    // block or not. Not always inside the exemplar.
    Spot land(int piece, int block_x, int block_y, int at_level, int x, int y) const;
    // The land of cell (x, y) of `level`, seams counted.
    Spot at(int x, int y) const;
};

// A patchwork (Efros and Freeman 2001) of pieces, `side` cells of the coarsest level
// wide. Each meets its four neighbours where it is most like them in height and
// roughness, so that plains run out into plains and ranges go on; but it is not what
// follows in the exemplar, so that no copy of it grows, and of all pieces about as much
// is taken, the same land as far apart as can be. The seam between two lies where they
// differ least.
Layout laid_out(const Database& database, int side, int orientations, std::uint64_t seed);

}  // namespace cydonia::texture
