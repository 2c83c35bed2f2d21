#pragma once

#include <cstdint>

namespace cydonia::render {

// Two octaves of gradient noise at a point in metres, about -1.5 to 1.5. It reads a table
// and is six times as fast as field/noise.h; only colours use it. Each octave repeats
// after 64 wavelengths, but the two are turned against each other and never repeat
// together.
double texture_noise(double east, double south, double wavelength, std::uint64_t seed);

}  // namespace cydonia::render
