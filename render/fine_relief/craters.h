#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::render {

// One octave of craters with diameters from half of `diameter` to `diameter` (metres), as
// heights to add, metres. They are scattered as on old ground, with equally many per
// diameter squared in every octave (N(>D) ~ D^-2), and differ in age. A fresh crater is a
// bowl a fifth of its diameter deep, with a rim and ejecta (Pike 1977, Size-dependence in
// the shape of fresh impact craters on the moon).
Field<float> craters(int width, int height, double spacing, double diameter,
                     std::uint64_t seed);

}  // namespace cydonia::render
