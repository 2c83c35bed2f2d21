#pragma once

#include <cstdint>

#include "field/field.h"
#include "synth/pareidolia/light_frame.h"

namespace cydonia::pareidolia {

// Step 4: the band around the shadows that must stay lit, `reach` cells wide.
Field<std::uint8_t> anti_shadow(const Field<std::uint8_t>& target, double reach);

// The greatest height in metres at which a secondary feature may start at each cell
// without changing the image's shadows: b_b of Rusnell 2009, Algorithms 5 to 7, as a
// height. `rise` is tan(elevation) times the cell size, and `highest` is the height of
// the tallest primary feature.
Field<float> height_bound(const Field<float>& base, const Field<std::uint8_t>& target,
                          const Field<std::uint8_t>& anti_shadow, double azimuth,
                          double rise, double highest);

}  // namespace cydonia::pareidolia
