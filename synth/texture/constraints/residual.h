#pragma once

#include <algorithm>

#include "field/field.h"
#include "synth/texture/constraints/guidance.h"

namespace cydonia::texture {

// How what eq. 8-9 leave of a constraint's error is taken off, in cells of the level.
struct ResidualSpread {
    int radius = 8;      // R: no cell farther from a constraint is touched
    int along = 4;       // land rougher than this along a constraint stays
    double near = 0.75;  // cells nearer than this are the constraint's own

    // Cells of a window's border that may differ from those of a larger window.
    int halo() const { return radius + std::max(along, 2); }
};

// Metres to add to the heights of a window's cells so that they come to what is asked at
// constraints: the constraints' residuals, averaged along them and carried outwards by a
// normalised convolution, under a bell that falls to nothing at R cells, with no slope
// there nor on the constraint: the residual r of a line makes no slope above 1.6 r / R.
// Cells inside the halo depend on their place only. `cell` is the level's, metres.
Field<float> residual_correction(const Field<Pull>& pulls, const Field<float>& heights,
                                 double cell, const ResidualSpread& spread = {});

}  // namespace cydonia::texture
