#pragma once

#include <vector>

#include "synth/statistics/features.h"
#include "synth/statistics/scale_space.h"

namespace cydonia::genetic {

struct Ridges {
    std::vector<Feature> ridges, valleys;
    std::vector<Feature> peaks;  // of one sample, without a length
};

// Lines along which land is highest or lowest across itself, by scale-space detection
// with automatic scale selection (Lindeberg 1998, section 5; Saunders 2006, section
// III.3.2): where t^(3/4) |Lpp - Lqq|, the difference of the principal curvatures, is
// largest over scales, and the surface across the line has its top or bottom in that very
// sample. A ridge whose section is a Gaussian curve is found at that curve's deviation.
// Strengths are that response, t in samples^2. Peaks are where t^2 (Lxx Lyy - Lxy^2) is
// largest over scales and in the plane (Lindeberg 1998, section 7), their strength its
// square root. `land` is the scale space of heights by metres from sample to sample.
Ridges ridges_of(const std::vector<Scale>& land, double spacing);
Ridges ridges_of(const Field<float>& heights, double spacing);

}  // namespace cydonia::genetic
