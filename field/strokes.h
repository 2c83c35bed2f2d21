#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "field/field.h"
#include "field/image.h"
#include "field/source.h"

namespace cydonia {

// Reads strokes as width x height cells: each is opaque or, where nothing is drawn, all
// zero. White (250 and above) and what is less than half opaque count as nothing. The SVG
// or image is stretched to the grid. A cell that a stroke touches is drawn, in the colour
// that most of the cell's strokes have, so that colours do not mix and no stroke
// vanishes. Throws bad_request when nothing is drawn.
//
// With a palette the cells have only its colours: a pixel counts as the nearest of them,
// if that differs by at most 48 in each channel. Other colours are the fringe of a stroke
// within two pixels of it; anywhere else they are a bad_request that names the colour.
// Without a palette an image of more than 16 colours (antialiased or JPEG) counts as
// drawn in black where it is dark or saturated.
Field<Rgba8> read_strokes(const Source& source, int width, int height,
                          std::span<const std::array<std::uint8_t, 3>> palette = {});

// Reads an SVG or image as grey from 0 to 1 over white, stretched to width x height (area
// average), for targets and masks.
Field<float> read_grey_at(const Source& source, int width, int height);

}  // namespace cydonia
