#pragma once

#include <array>
#include <vector>

#include "synth/distance/site.h"

namespace cydonia::distance {

// How far along the feature each of its places lies: 0 at the western end of an open
// stroke (the northern one of two), 1 at the other; 0 at the westernmost place of a
// closed one, 1 where both ways round from there meet. Connected parts count by
// themselves.
std::vector<float> along(const Shape& shape);

// At each place a unit vector (east, south) to the left of an open stroke, walked from
// where `along` is 0, or into a closed one. Directions are taken over `reach` metres.
std::vector<std::array<float, 2>> left_sides(const Shape& shape, double reach);

}  // namespace cydonia::distance
