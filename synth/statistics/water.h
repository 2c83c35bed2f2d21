#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::genetic {

// 1 where water stands: samples of one height that hang together, many of them and some
// way across, since a body of water has constant elevation (Saunders 2006, section
// VII.5). Plains whose heights were rounded to metres have level bands too, but narrow
// ones.
Field<std::uint8_t> water_of(const Field<float>& heights);

// The mask and all that is at most so many samples from it, along x and along y.
Field<std::uint8_t> grown(const Field<std::uint8_t>& mask, int samples);

// The mask on another grid from the same north-west corner, whose samples are `cell` of
// the mask's a side: 1 where one touches any that is set.
Field<std::uint8_t> touched(const Field<std::uint8_t>& mask, double cell, int width,
                            int height);

}  // namespace cydonia::genetic
