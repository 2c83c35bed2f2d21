#pragma once

#include <span>

#include "synth/detail/example.h"
#include "synth/detail/window.h"

namespace cydonia::detail {

// Root of the mean square of values within so many cells each way.
Field<float> strength_of(const Field<float>& values, int around);

// Details replaced by how strong they are around each place, in metres: the local scale
// of a multi-fractal (Brosz 2007, section 5.1).
void take_scale(Example& example);

// Strengths times normal noise of a level: a multi-fractal's details. Of a window of the
// whole level's coarse land.
void make_noise(Details& strengths, const Window& window, std::uint64_t seed, int level);

// How strong the noise of a level is, metres: of the examples' coarsest level what
// subdivision alone does not give, and 2^-H less at each finer one (Voss 1985).
double fractal_scale(std::span<const Example> examples, Filter filter, int level,
                     int levels);

// Adds normal noise of that strength, times `share` (empty: 1), to all samples:
// successive random additions.
// The land is a window of the whole.
void add_noise(Field<float>& land, const Window& window, double strength,
               const Field<float>& share, std::uint64_t seed, int level);

}  // namespace cydonia::detail
