#pragma once

#include <cstdint>

#include "field/field.h"
#include "synth/pareidolia/light_frame.h"

namespace cydonia::pareidolia {

// Step 4: the band around the shadows that must stay free of shadow, `reach` cells wide.
Field<std::uint8_t> anti_shadow(const Field<std::uint8_t>& target, double reach);

// How high a secondary feature may start at each cell, in metres, so that it leaves the
// image's shadows as they are: b_b of Rusnell 2009, Algorithms 5 to 7, as a height.
// `rise` is tan(elevation) times the cell size; `highest` the tallest primary feature.
Field<float> height_bound(const Field<float>& base, const Field<std::uint8_t>& target,
                          const Field<std::uint8_t>& anti_shadow, double azimuth,
                          double rise, double highest);

}  // namespace cydonia::pareidolia
