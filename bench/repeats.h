#pragma once

#include "field/field.h"
#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::bench {

// The same feature twice in view: exemplars are cut into blocks of `side` cells, and a
// block is shown where at least half of it lies on the land as it lies in its exemplar,
// give or take some cells.
struct Repeats {
    double share = 0.0;    // of the land: shown blocks that are shown elsewhere too
    double nearest = 0.0;  // cells between two showings of a block; 0: there are none
    int most = 0;          // showings of one block
};
Repeats repeats(const Field<texture::Origin>& places, int side);

}  // namespace cydonia::bench
