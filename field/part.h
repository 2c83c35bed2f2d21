#pragma once

#include <algorithm>

#include "field/field.h"

namespace cydonia {

// The cells [x, x + width) x [y, y + height) of `from`, which must contain them.
template <class T>
Field<T> part(const Field<T>& from, int x, int y, int width, int height) {
    Field<T> result(width, height);
    for (int row = 0; row < height; ++row)
        std::copy_n(from.row(y + row).begin() + x, width, result.row(row).begin());
    return result;
}

}  // namespace cydonia
