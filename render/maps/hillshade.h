#pragma once

#include "field/image.h"
#include "field/terrain.h"

namespace cydonia::render {

// Shaded relief, one value a sample, 0 (dark) to 1 (bright): light from the north-west
// softened by light from the west, the north and above. Slopes are exaggerated or calmed
// until the land fills the tones. `heights` and `spacing` in metres.
Field<float> relief(const Field<float>& heights, double spacing);

// A picture of land for people to look at: relief under a quiet tint from low to high, at
// most `longest` pixels a side.
// Under water the bed shows through blue, the darker the deeper.
Field<Rgb8> hillshade(const Terrain& terrain, int longest = 1024);

}  // namespace cydonia::render
