#pragma once

#include "field/field.h"
#include "field/image.h"
#include "field/source.h"

namespace cydonia {

// Strokes as an image of width x height cells, transparent where nothing is drawn. SVG is
// drawn through librsvg, stretched to the grid, with crisp edges so that colours do not
// mix; PNG is resampled to the nearest pixel, but no stroke vanishes. White counts as
// nothing. Throws bad_request when no pixel is drawn.
Field<Rgba8> read_strokes(const Source& source, int width, int height);

// Grey 0 to 1 of an SVG or image stretched to width x height (area average): targets,
// masks.
Field<float> read_grey_at(const Source& source, int width, int height);

}  // namespace cydonia
