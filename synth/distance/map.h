#pragma once

#include "field/field.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// A map's values at width x height samples: the luma of its picture (with Rec.709's
// weights; eq. 4.4 has Rec.601's), stretched over them, from range[0] at black to
// range[1] at white.
Field<float> map_values(const Map& map, int width, int height);

}  // namespace cydonia::distance
