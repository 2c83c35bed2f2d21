#pragma once

#include <optional>

#include "field/quantise.h"
#include "field/terrain.h"

namespace cydonia::render {

// The surface of seas and lakes as a height field on the land's grid. At a wet sample it
// is at its level. Beside one it is at the same level or, where the land is lower, just
// under the land, so that the two meshes meet at the shore and nowhere else. Elsewhere
// there is none: level 0, all others are above.
struct WaterSurface {
    Heights16 heights;
    // Of the lowest water that reaches the border of the land, metres, if any does: the
    // sea, which goes on outside.
    std::optional<double> sea;
};

// Nothing where no sample is wet.
std::optional<WaterSurface> water_surface(const Terrain& terrain);

}  // namespace cydonia::render
