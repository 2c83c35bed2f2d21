#pragma once

#include <cstdint>

#include "field/field.h"
#include "synth/pareidolia/region_tree.h"

namespace cydonia::pareidolia {

// 1 in every shadow and in what it surrounds.
Field<std::uint8_t> filled_shadows(const RegionTree& tree);

// Section 5.4: random points of the `holes` (their ground, kNowhere elsewhere), which
// stand just above the shadow line; kNowhere where none is.
Field<float> hole_points(const Field<float>& holes, std::uint64_t seed);

}  // namespace cydonia::pareidolia
