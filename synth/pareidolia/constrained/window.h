#pragma once

#include <cstdint>

#include "field/field.h"
#include "field/terrain.h"

namespace cydonia::pareidolia {

// Where an image counts: around it, its gaps closed, with a border that wanders by
// `noise` (0 to 1, same shape) so that no eye finds it.
Field<std::uint8_t> window_of(const Field<std::uint8_t>& target,
                              const Field<float>& noise);

}  // namespace cydonia::pareidolia
