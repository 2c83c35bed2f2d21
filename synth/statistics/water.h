#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::statistics {

// 1 on water. A body of water has constant elevation (Saunders 2006, section VII.5): it
// is a large and broad group of connected samples of one height. Plains whose heights
// were rounded to metres have level bands too, but narrow ones.
Field<std::uint8_t> water_of(const Field<float>& heights);

// The mask, grown by so many samples along x and y.
Field<std::uint8_t> grown(const Field<std::uint8_t>& mask, int samples);

// The mask on another grid with the same north-west corner, whose samples are `cell`
// samples of the mask wide. It is 1 where a sample touches any that is set.
Field<std::uint8_t> touched(const Field<std::uint8_t>& mask, double cell, int width,
                            int height);

}  // namespace cydonia::statistics
