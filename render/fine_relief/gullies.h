#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::render {

// One octave of gullies that run down the slope, side by side at about a wavelength
// (metres), of the same shape as the heights. Values are -1 in a gully and 1 on the rib
// between two, times a strength of 0 to 1 that depends on the slope. A wavelength is at
// least four cells. The method blends and normalises cosine stripes from scattered points
// (Tricard et al. 2019, Procedural phasor noise, section 4), directed by the slope
// (Grenier et al. 2024, Real-time terrain enhancement with controlled procedural
// patterns).
Field<float> gullies(const Field<float>& heights, double spacing, double wavelength,
                     std::uint64_t seed);

}  // namespace cydonia::render
