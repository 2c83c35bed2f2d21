#pragma once

#include <cstdint>

#include "field/field.h"
#include "synth/pareidolia/region_tree.h"

namespace cydonia::pareidolia {

// A mask that is 1 in every shadow and in everything that it surrounds.
Field<std::uint8_t> filled_shadows(const RegionTree& tree);

// Section 5.4: random points in the holes that stand just above the shadow line. `holes`
// is the ground of the holes, kNowhere elsewhere. The result is kNowhere where there is
// no point.
Field<float> hole_points(const Field<float>& holes, std::uint64_t seed);

}  // namespace cydonia::pareidolia
