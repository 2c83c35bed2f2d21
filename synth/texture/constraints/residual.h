#pragma once

#include <algorithm>

#include "field/field.h"
#include "synth/texture/constraints/guidance.h"

namespace cydonia::texture {

// How the error that eq. 8-9 leave at constraints is removed. Lengths are cells of the
// level.
struct ResidualSpread {
    int radius = 8;      // R: cells farther from a constraint are not changed
    int along = 4;       // residuals are averaged over so many cells along a constraint
    double near = 0.75;  // cells nearer than this are the constraint's own

    // Cells of a window's border that may differ from those of a larger window.
    int halo() const { return radius + std::max(along, 2); }
};

// What to add to the heights of a window's cells, in metres, so that they reach what is
// asked at constraints. The constraints' residuals are averaged along them and carried
// outwards by a normalised convolution, under a bell that falls to 0 at R cells and has
// no slope there nor on the constraint: the residual r of a line makes no slope above 1.6
// r / R. Cells inside the halo depend on their position only. `cell` is the level's,
// metres.
Field<float> residual_correction(const Field<Pull>& pulls, const Field<float>& heights,
                                 double cell, const ResidualSpread& spread = {});

}  // namespace cydonia::texture
