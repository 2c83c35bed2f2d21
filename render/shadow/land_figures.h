#pragma once

#include "field/field.h"

namespace cydonia::render {

// Figures that tell natural land from land that was bent too much.
struct LandFigures {
    double range = 0.0;  // metres from the lowest sample to the highest
    // The 99th percentile of the slopes of the mesh's triangles, as a tangent.
    double slope = 0.0;
    // Excess kurtosis of the Laplacian over four neighbours, without two cells at the
    // border: 0 for noise, 6 to 12 for mountains, large where few cells hold cliffs.
    double kurtosis = 0.0;
};

// `heights` and `spacing` are in metres. Throws bad_request for less than 5 x 5 samples.
LandFigures land_figures(const Field<float>& heights, double spacing);

}  // namespace cydonia::render
