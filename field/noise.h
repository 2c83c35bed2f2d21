#pragma once

#include <cstdint>

#include "field/field.h"
#include "field/length.h"

namespace cydonia {

// Gradient noise (Perlin 2002) at a point: in about [-1, 1], and 0 at integer points. The
// gradients of the lattice are a hash of `seed`.
double gradient_noise(double x, double y, std::uint64_t seed);

// Rusnell 2009, Algorithm 1 and section 4.1; ridged: Musgrave's ridged multifractal.
struct NoiseOptions {
    enum class Kind { kFbm, kRidged };
    Kind kind = Kind::kFbm;
    double h = 3.0;  // H, the Hoelder exponent: smaller is rougher
    double lacunarity = 2.0;
    int octaves = 2;    // Algorithm 1 counts from 0 to octaves inclusive
    double grid = 4.0;  // lattice cells across the terrain's width
    Length scale = thesis_units(30.0);
    double offset = 1.0;  // ridged only
    double gain = 2.0;    // ridged only
    bool operator==(const NoiseOptions&) const = default;
};

// The unscaled value at (x, y), which are fractions of the terrain's width.
double noise_at(const NoiseOptions& options, double x, double y, std::uint64_t seed);

// The values at the cell centres of a width x height grid whose width spans 1, times
// `scale` metres.
Field<float> noise_field(const NoiseOptions& options, int width, int height, double scale,
                         std::uint64_t seed);

}  // namespace cydonia
