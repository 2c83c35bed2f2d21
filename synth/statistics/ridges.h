#pragma once

#include <vector>

#include "synth/statistics/features.h"
#include "synth/statistics/scale_space.h"

namespace cydonia::statistics {

struct Ridges {
    std::vector<Feature> ridges, valleys;
    std::vector<Feature> peaks;  // of one sample, without a length
};

// Ridges and valleys, the lines along which land is highest or lowest across the line,
// found by scale-space detection with automatic scale selection (Lindeberg 1998, section
// 5; Saunders 2006, section III.3.2): where t^(3/4) |Lpp - Lqq|, the difference of the
// principal curvatures, is largest over scales, and the surface across the line has its
// top or bottom in that sample. A ridge with a Gaussian section is found at that curve's
// deviation. A strength is that response, with t in samples^2. Peaks are where t^2 (Lxx
// Lyy - Lxy^2) is largest over scales and in the plane (Lindeberg 1998, section 7); their
// strength is its square root. `land` is the scale space of heights divided by the
// spacing; `spacing` is in metres.
Ridges ridges_of(const std::vector<Scale>& land, double spacing);
Ridges ridges_of(const Field<float>& heights, double spacing);

}  // namespace cydonia::statistics
