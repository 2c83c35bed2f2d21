#pragma once

#include "field/image.h"
#include "field/terrain.h"

namespace cydonia::render {

// A cast shadow (rays x rays samples a cell) held against its image, a pixel a sample,
// over a faint relief (0 to 1, a value a cell): blue hit, yellow missed, pink spurious,
// violet where the image gave way to another; outside its window, whose border is a thin
// line, shadow is grey.
Field<Rgb8> overlay(const Field<std::uint8_t>& cast, const ShadowImage& image,
                    const Field<float>& relief);

}  // namespace cydonia::render
