#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::hydrology {

inline constexpr int kBreachRadius = 32;

// The outcome of breach().
struct Breached {
    int cut = 0;           // minima that drain now
    int left = 0;          // minima that still have no way out, such as lakes and craters
    float deepest = 0.0f;  // the most that a cell was lowered, metres
};

// Cuts, from every minimum (synth/hydrology/depressions.h), the channel to lower land
// that takes the least material off the land, no longer than `radius` cells each way and
// no deeper than a cell is wide: Lindsay and Dhun, "Modelling surface drainage patterns
// in altered landscapes using LiDAR", 2015. Deep channels get banks. Cells where `locked`
// is not 0 keep their height (empty: none); no height rises and no minimum appears that
// was not there. `spacing` in metres. The result has the same bytes for any number of
// threads.
Breached breach(Field<float>& heights, double spacing,
                const Field<std::uint8_t>& locked = {}, int radius = kBreachRadius);

}  // namespace cydonia::hydrology
