#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia {

// A mask that is 1 in the cells that walls enclose: cells without a wall that cannot be
// reached from beyond the field's border. Ways cross the sides of cells, not their
// corners. `walls` is not 0 where there is a wall.
Field<std::uint8_t> enclosed_by(const Field<std::uint8_t>& walls);

}  // namespace cydonia
