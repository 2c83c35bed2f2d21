#pragma once

#include <cstdint>

#include "field/field.h"

namespace cydonia::texture {

inline constexpr int kBreachRadius = 32;

// What was done about channels that end nowhere.
struct Breached {
    int cut = 0;           // minima that were given a way out
    int left = 0;          // those that have none, as lakes and craters
    float deepest = 0.0f;  // most that was taken off a cell, metres
};

// From every minimum (synth/hydrology/depressions.h), the channel out within `radius`
// cells, no deeper than a cell is wide, that takes the least material off the land:
// Lindsay and Dhun, "Modelling surface drainage patterns in altered landscapes using
// LiDAR", 2015. Deep channels get banks. Cells where `locked` is not 0 keep their height
// (empty: none); no height rises and no minimum appears that was not there. `spacing` in
// metres. Equal bytes for equal input.
Breached breach(Field<float>& heights, double spacing,
                const Field<std::uint8_t>& locked = {}, int radius = kBreachRadius);

}  // namespace cydonia::texture
