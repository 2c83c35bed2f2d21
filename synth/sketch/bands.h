#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"

namespace cydonia::sketch {

// Multi-scale analysis with the filters of Cook and DeRose (2005): Gain, Marais and
// Strasser 2009, section 4. Beyond its sides a field is mirrored. Lines have one row.

Field<float> halved(const Field<float>& field);  // sides rounded up
Field<float> doubled(const Field<float>& field, int width, int height);

// I_0 to I_m of a field, all as large as it is, the smoothest first, the last the field
// itself: in I_i is what is wider than phi_i = 2^(m - i) samples.
std::vector<Field<float>> smoothed(const Field<float>& field, int levels);

// What band i of white noise has, 0 < i <= m: what is narrower than phi_(i-1) samples and
// wider than phi_i. Of mean square 1. A window of an endless plane, from column x and row
// y on, multiples of phi_0.
Field<float> wavelet_noise(int x, int y, int width, int height, int band, int levels,
                           std::uint64_t seed);

}  // namespace cydonia::sketch
