#pragma once

#include "field/image.h"
#include "field/terrain.h"

namespace cydonia::render {

// Shaded relief with one value a sample, 0 (dark) to 1 (bright). The main light comes
// from the north-west, with weaker light from the west, the north and above. Slopes are
// exaggerated or reduced until the land uses all tones. `heights` and `spacing` are in
// metres.
Field<float> relief(const Field<float>& heights, double spacing);

// A picture of the land for people to look at, at most `longest` pixels a side: shaded
// relief, tinted by height. Under water the bed shows through blue that darkens with
// depth.
Field<Rgb8> hillshade(const Terrain& terrain, int longest = 1024);

}  // namespace cydonia::render
