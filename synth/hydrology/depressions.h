#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::hydrology {

// Water runs from a cell to any lower one of its eight neighbours, and leaves the land
// over its edge. These functions find where it cannot.

// Minima: cells, or connected cells of equal height, that have no lower neighbour and are
// not at the edge. The first cell of each, the lowest first; equal ones in the field's
// order.
std::vector<std::int32_t> minima_of(const Field<float>& heights);

// How many of a thousand inner cells are lower than all eight neighbours.
double pits_per_1000(const Field<float>& heights);

// Hollows in which channels end.
struct Depressions {
    int count = 0;
    float deepest = 0.0f;  // depth of water in the deepest when it overflows, metres
    Field<float> mask;     // 1 where water stands
};
Depressions depressions_of(const Field<float>& heights);

}  // namespace cydonia::hydrology
