#pragma once

#include "field/field.h"

namespace cydonia::render {

// What tells natural land from land that was bent too much.
struct LandFigures {
    double range = 0.0;  // metres from the lowest sample to the highest
    // Tangent that 99 of 100 of the mesh's triangles stay below.
    double slope = 0.0;
    // Excess kurtosis of the Laplacian over four neighbours, two cells at the border left
    // out: 0 for noise, 6 to 12 for mountains, large where a few cells hold cliffs.
    double kurtosis = 0.0;
};

// `heights` and `spacing` in metres; at least 5 x 5 samples, else bad_request.
LandFigures land_figures(const Field<float>& heights, double spacing);

}  // namespace cydonia::render
