#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::render {

// One octave of gullies, side by side at about a wavelength (metres), each along the
// fall of the land: -1 (in a gully) to 1 (on the rib between two), times how much room
// the slope gives them, 0 to 1. Same shape as the heights, of which a wavelength is at
// least four cells. Stripes of cosines from scattered points, blended and normalised
// (Tricard et al. 2019, Procedural phasor noise, section 4; along the slope as Grenier et
// al. 2024, Real-time terrain enhancement with controlled procedural patterns).
Field<float> gullies(const Field<float>& heights, double spacing, double wavelength,
                     std::uint64_t seed);

}  // namespace cydonia::render
