#pragma once

#include <vector>

#include "synth/statistics/features.h"
#include "synth/statistics/scale_space.h"

namespace cydonia::statistics {

// Lines along which land is steepest, found by scale-space detection with automatic scale
// selection (Lindeberg 1998; Saunders 2006, section III.3.2.2): where t^(1/2) |grad L|^2
// is largest over scales and along the slope. A diffuse step is found at its own width. A
// strength is t^(1/4) |grad L| with t in samples^2. `land` is the scale space of heights
// divided by the spacing; `spacing` is in metres.
std::vector<Feature> edges_of(const std::vector<Scale>& land, double spacing);
std::vector<Feature> edges_of(const Field<float>& heights, double spacing);

}  // namespace cydonia::statistics
