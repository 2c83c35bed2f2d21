#pragma once

#include <string>
#include <vector>

#include "field/field.h"
#include "synth/texture/constraints/geometry.h"

namespace cydonia::texture {

// How far the land is from the height that a constraint asks for, in metres.
struct ConstraintError {
    std::string name;
    double max = 0.0;  // of the absolute error
    double rms = 0.0;
    int sites = 0;  // number of places measured; 0: none lies on the terrain
};

struct ConstraintErrors {
    std::vector<ConstraintError> each;  // in the order of Geometry::names()
    ConstraintError all;                // without a name
};

// Errors of heights that lie `spacing` metres apart; between samples the land is
// bilinear.
ConstraintErrors constraint_errors(const Geometry& geometry, const Field<float>& heights,
                                   double spacing);

}  // namespace cydonia::texture
