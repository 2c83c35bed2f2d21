#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::render {

// Twenty silhouettes that nobody asked for: letters, digits, polygons, stars, crosses,
// rings, of many sizes and places. 1 in shadow, as targets. The same for every call.
std::vector<Field<std::uint8_t>> distractors(int width, int height);

}  // namespace cydonia::render
