#pragma once

#include <algorithm>

#include "field/field.h"

namespace cydonia {

// Calls visit(x, y) for every sample on the field's border, and twice for the corners.
template <class T, class Visit>
void on_border(const Field<T>& field, const Visit& visit) {
    const int right = field.width() - 1, bottom = field.height() - 1;
    for (int x = 0; x <= right; ++x) visit(x, 0), visit(x, bottom);
    for (int y = 0; y <= bottom; ++y) visit(0, y), visit(right, y);
}

// The lowest value on the border of a field, which must have at least one sample.
template <class T>
T lowest_on_border(const Field<T>& field) {
    T lowest = field(0, 0);
    on_border(field, [&](int x, int y) { lowest = std::min(lowest, field(x, y)); });
    return lowest;
}

}  // namespace cydonia
