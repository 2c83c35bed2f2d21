#pragma once

#include "field/image.h"
#include "render/embree/style.h"
#include "render/scene/shot.h"

namespace cydonia::render {

// Draws the land alone, without things or shadows, in a style that shows its form (any
// but Style::kNatural). The picture is sRGB. Throws bad_request as View does.
Field<Rgb8> diagram(const Shot& shot, const Terrain& terrain, Style style);

// The smallest of 1, 2 and 5 times a power of ten that is at least `least`, metres.
double round_interval(double least);
// The distances in metres between a diagram's contour lines and between its grid lines.
double contour_interval(const Terrain& terrain);
double grid_interval(const Terrain& terrain);

}  // namespace cydonia::render
