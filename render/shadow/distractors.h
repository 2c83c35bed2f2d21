#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::render {

// Twenty silhouettes to compare a cast shadow with: letters, digits, polygons, stars,
// crosses and rings of many sizes and positions. Masks are 1 in shadow, as targets are,
// and the same for every call.
std::vector<Field<std::uint8_t>> distractors(int width, int height);

}  // namespace cydonia::render
