#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::render {

// One octave of broken ground of about a wavelength (metres): about -1 to 1, round in
// half of the places and ridged in the others, times how rough the slope is: a sixteenth
// on level ground, all of it on walls. Same shape as the heights.
Field<float> crags(const Field<float>& heights, double spacing, double wavelength,
                   std::uint64_t seed);

}  // namespace cydonia::render
