#pragma once

#include <span>

#include "synth/detail/example.h"
#include "synth/detail/window.h"

namespace cydonia::detail {

// The root mean square of the values within `around` cells each way.
Field<float> strength_of(const Field<float>& values, int around);

// Replaces details with their strength around each position in metres, the local scale of
// a multi-fractal (Brosz 2007, section 5.1).
void take_scale(Example& example);

// Multiplies strengths by normal noise of a level, which gives a multi-fractal's details.
// `window` is where the level's coarse land lies in that of the whole land.
void make_noise(Details& strengths, const Window& window, std::uint64_t seed, int level);

// The strength of a level's noise in metres. On the examples' coarsest level it is that
// of their details; on each finer level it is smaller by a factor of 2^-H (Voss 1985).
double fractal_scale(std::span<const Example> examples, Filter filter, int level,
                     int levels);

// Adds normal noise of a strength times `share` (empty: 1) to all samples (successive
// random additions). The land is a window of the whole.
void add_noise(Field<float>& land, const Window& window, double strength,
               const Field<float>& share, std::uint64_t seed, int level);

}  // namespace cydonia::detail
