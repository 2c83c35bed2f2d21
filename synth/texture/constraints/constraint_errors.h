#pragma once

#include <string>
#include <vector>

#include "field/field.h"
#include "synth/texture/constraints/geometry.h"

namespace cydonia::texture {

// How far land is from what a constraint asks, metres.
struct ConstraintError {
    std::string name;
    double max = 0.0;  // of the absolute error
    double rms = 0.0;
    int sites = 0;  // where it was measured; 0: nowhere on the terrain
};

struct ConstraintErrors {
    std::vector<ConstraintError> each;  // as Geometry::names()
    ConstraintError all;                // without a name
};

// Of a terrain's heights `spacing` metres apart, bilinear between its samples.
ConstraintErrors constraint_errors(const Geometry& geometry, const Field<float>& heights,
                                   double spacing);

}  // namespace cydonia::texture
