#pragma once

#include <vector>

#include "synth/context.h"
#include "synth/genetic/evolution/height_field.h"
#include "synth/geometry/options.h"

namespace cydonia::genetic {

// Placed features (section VII.2) as points and curves of the texture method (Gain 2015,
// section 5.1): the land of every level is brought to their heights, over their areas on
// coarse levels and beside them on fine ones. Relative heights are added to the base
// level's land. Empty without any.
Features features_of(const std::vector<texture::Point>& points,
                     const std::vector<texture::Curve>& curves, const Extent& extent,
                     Progress& progress);

}  // namespace cydonia::genetic
