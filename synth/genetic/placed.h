#pragma once

#include <vector>

#include "synth/context.h"
#include "synth/genetic/evolution/height_field.h"
#include "synth/geometry/options.h"

namespace cydonia::genetic {

// A function that applies placed features (section VII.2), which are points and curves of
// the texture method (Gain 2015, section 5.1). It brings the land of each level to their
// heights: within their whole areas on coarse levels and close to them on fine ones.
// Relative heights are added to the base level's land. The function is empty where there
// are no features.
PlacedFeatures features_of(const std::vector<geometry::Point>& points,
                           const std::vector<geometry::Curve>& curves,
                           const Extent& extent, Progress& progress);

}  // namespace cydonia::genetic
