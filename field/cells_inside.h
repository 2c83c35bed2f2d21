#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia {

// Cells, middle to middle, from every cell whose truth in `mask` is `value` to the
// nearest one whose is not; 0 at those. Where there are none, a number beyond any
// distance.
Field<float> cells_inside(const Field<std::uint8_t>& mask, bool value);

}  // namespace cydonia
