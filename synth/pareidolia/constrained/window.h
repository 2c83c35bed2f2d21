#pragma once

#include <cstdint>

#include "field/field.h"
#include "field/terrain.h"

namespace cydonia::pareidolia {

// The window in which an image counts: the image with its gaps closed and ground around
// it. `noise` (0 to 1, same shape) makes its border irregular, so that it cannot be seen.
Field<std::uint8_t> window_of(const Field<std::uint8_t>& target,
                              const Field<float>& noise);

}  // namespace cydonia::pareidolia
