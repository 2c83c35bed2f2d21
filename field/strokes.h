#pragma once

#include "field/field.h"
#include "field/image.h"
#include "field/source.h"

namespace cydonia {

// Strokes as an image of width x height cells: each pixel opaque or, where nothing is
// drawn, all zero. White (250 and above) and less than half opaque count as nothing. SVG
// or an image is stretched to the grid; a cell is drawn where a stroke touches it, in the
// colour that most of it has, so that colours do not mix and no stroke vanishes. Throws
// bad_request when nothing is drawn.
Field<Rgba8> read_strokes(const Source& source, int width, int height);

// Grey 0 to 1 over white of an SVG or image stretched to width x height (area average):
// targets, masks.
Field<float> read_grey_at(const Source& source, int width, int height);

}  // namespace cydonia
