#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::texture {

// Water runs from cell to lower cell, eight ways, and leaves the land over its edge.
// These say where it cannot.

// Cells, or groups of equal cells that touch, that have no lower neighbour and are not at
// the edge: the first cell of each, lowest first, equal ones in the field's order.
std::vector<std::int32_t> minima_of(const Field<float>& heights);

// Cells lower than all eight neighbours, of a thousand that have so many.
double pits_per_1000(const Field<float>& heights);

// Channels that end nowhere.
struct Depressions {
    int count = 0;
    float deepest = 0.0f;  // metres of water that stands until it runs over
    Field<float> mask;     // 1 where water stands
};
Depressions depressions_of(const Field<float>& heights);

}  // namespace cydonia::texture
