#pragma once

#include "field/image.h"
#include "field/terrain.h"

namespace cydonia::render {

// A picture that compares a cast shadow (rays x rays samples a cell) with its image, a
// pixel a sample, over a faint relief (0 to 1, a value a cell). Hits are blue, misses
// yellow, spurious shadow pink, and cells that were left to another image violet. A thin
// line bounds the window, and shadow outside it is grey.
Field<Rgb8> overlay(const Field<std::uint8_t>& cast, const ShadowImage& image,
                    const Field<float>& relief);

}  // namespace cydonia::render
