#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::render {

// One octave of broken ground at about a wavelength (metres), of the same shape as the
// heights. Values are about -1 to 1, round in one half of the land and ridged in the
// other, times a roughness that rises from a sixteenth on level ground to 1 on walls.
Field<float> crags(const Field<float>& heights, double spacing, double wavelength,
                   std::uint64_t seed);

}  // namespace cydonia::render
