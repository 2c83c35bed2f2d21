#pragma once

#include "field/image.h"
#include "render/embree/style.h"
#include "render/scene/shot.h"

namespace cydonia::render {

// The land alone, without things or shadows, in a style that shows its form: any but
// natural. For a screen as it is: sRGB. Throws bad_request as View does.
Field<Rgb8> diagram(const Shot& shot, const Terrain& terrain, Style style);

// 1, 2 or 5 times a power of ten, metres: at least `least`.
double round_interval(double least);
// Metres between a diagram's lines of equal height, and between those of its grid.
double contour_interval(const Terrain& terrain);
double grid_interval(const Terrain& terrain);

}  // namespace cydonia::render
