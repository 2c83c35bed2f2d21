#pragma once

#include <cstdint>

namespace cydonia::render {

// Two octaves of gradient noise at a point in metres, in about [-1.5, 1.5], by a table:
// six times as fast as field/noise.h, for colours only. It repeats after 64 wavelengths,
// its octaves, turned against each other, never together.
double texture_noise(double east, double south, double wavelength, std::uint64_t seed);

}  // namespace cydonia::render
