#pragma once

#include <cstdint>
#include <numbers>

#include "field/field.h"

namespace cydonia::hydrology {

// Cells are given by their index, in fields of fewer than 2^31 cells.

template <class T>
bool at_edge(const Field<T>& field, std::int32_t cell) {
    const int x = cell % field.width(), y = cell / field.width();
    return x == 0 || y == 0 || x == field.width() - 1 || y == field.height() - 1;
}

// Calls visit(neighbour, distance in cells) for each of the up to eight neighbours, row
// by row.
template <class T, class Visit>
void for_neighbours(const Field<T>& field, std::int32_t cell, const Visit& visit) {
    const int x = cell % field.width(), y = cell / field.width();
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if ((dx != 0 || dy != 0) && field.contains(x + dx, y + dy))
                visit(cell + dy * field.width() + dx,
                      dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1.0);
}

}  // namespace cydonia::hydrology
