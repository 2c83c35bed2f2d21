#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::render {

// Twenty silhouettes that nobody asked for: letters, digits, polygons, stars, crosses,
// rings, of many sizes and places. 1 in shadow, as targets. The same for every call.
std::vector<Field<std::uint8_t>> distractors(int width, int height);

// How far a cast (a sample a cell) stands out as this target and not as another image:
// its correlation with the target, less the mean of those with the others, in standard
// deviations of theirs.
double standing_out(const Field<std::uint8_t>& cast, const Field<std::uint8_t>& target,
                    const std::vector<Field<std::uint8_t>>& others);

}  // namespace cydonia::render
