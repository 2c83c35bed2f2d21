#pragma once

#include <algorithm>

#include "field/field.h"

namespace cydonia {

// The bilinear value at (x, y) in cells, where integers are the centres of cells. Beyond
// the outer centres it is the nearest value. The field must have at least one cell.
inline float bilinear(const Field<float>& field, double x, double y) {
    x = std::clamp(x, 0.0, field.width() - 1.0);
    y = std::clamp(y, 0.0, field.height() - 1.0);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const int i1 = std::min(i + 1, field.width() - 1);
    const int j1 = std::min(j + 1, field.height() - 1);
    const double u = x - i, v = y - j;
    return static_cast<float>((1.0 - v) * ((1.0 - u) * field(i, j) + u * field(i1, j)) +
                              v * ((1.0 - u) * field(i, j1) + u * field(i1, j1)));
}

}  // namespace cydonia
