#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::sketch {

// Multi-scale analysis with the filters of Cook and DeRose (2005): Gain, Marais and
// Strasser 2009, section 4. Beyond its sides a field is mirrored. Lines have one row.

Field<float> halved(const Field<float>& field);  // sides rounded up
Field<float> doubled(const Field<float>& field, int width, int height);

// I_0 to I_m of a field, all of its size, the smoothest first. The last is the field
// itself; I_i has everything wider than phi_i = 2^(m - i) samples.
std::vector<Field<float>> smoothed(const Field<float>& field, int levels);

// Band i of white noise, 0 < i <= m: everything narrower than phi_(i-1) samples and wider
// than phi_i, with a mean square of 1. It is a window of an infinite plane, from column x
// and row y on, which are multiples of phi_0.
Field<float> wavelet_noise(int x, int y, int width, int height, int band, int levels,
                           std::uint64_t seed);

}  // namespace cydonia::sketch
