#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::render {

// One octave of craters, `diameter` to half of it (metres), scattered as on old ground:
// as many a diameter squared in every octave (N(>D) ~ D^-2), each of some age. Heights to
// add, metres: a bowl of a fifth of its diameter when fresh, a rim and what it threw out
// (Pike 1977, Size-dependence in the shape of fresh impact craters on the moon).
Field<float> craters(int width, int height, double spacing, double diameter,
                     std::uint64_t seed);

}  // namespace cydonia::render
