#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia {

// The distance transform of a mask, in cells from centre to centre: from every cell where
// `mask` is `value` to the nearest cell where it is not. It is 0 at the latter, and
// larger than any distance where there is no such cell.
Field<float> cells_inside(const Field<std::uint8_t>& mask, bool value);

}  // namespace cydonia
