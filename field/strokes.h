#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "field/field.h"
#include "field/image.h"
#include "field/source.h"

namespace cydonia {

// Strokes as an image of width x height cells: each pixel opaque or, where nothing is
// drawn, all zero. White (250 and above) and less than half opaque count as nothing. SVG
// or an image is stretched to the grid; a cell is drawn where a stroke touches it, in the
// colour that most of it has, so that colours do not mix and no stroke vanishes. Throws
// bad_request when nothing is drawn.
//
// With a palette the cells have its colours only: a pixel counts as the nearest of them
// within 48 a channel; others are the fringe of a stroke within two pixels of it, and
// anywhere else a bad_request that says their colour. Without one an image of more than
// 16 colours (antialiased, JPEG) counts as drawn in black where it is dark or saturated.
Field<Rgba8> read_strokes(const Source& source, int width, int height,
                          std::span<const std::array<std::uint8_t, 3>> palette = {});

// Grey 0 to 1 over white of an SVG or image stretched to width x height (area average):
// targets, masks.
Field<float> read_grey_at(const Source& source, int width, int height);

}  // namespace cydonia
