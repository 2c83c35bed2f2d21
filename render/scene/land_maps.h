#pragma once

#include <cstdint>

#include "field/terrain.h"
#include "render/ground/ground.h"
#include "render/options.h"

namespace cydonia::render {

// What is worked out of a land once, for all frames that show it. Each map covers the
// whole land, row 0 in the north. The ground's two maps have several pixels a sample; the
// albedo, which only the .pov takes, is by far the largest.
struct LandMaps {
    GroundMap ground;
    Field<float> sky_visibility;  // 0 to 1, rounded to the 16 bits that POV-Ray reads
};

LandMaps land_maps(const Terrain& terrain, const GroundOptions& ground, Quality quality);

}  // namespace cydonia::render
