#pragma once

#include <cstdint>

#include "field/terrain.h"
#include "render/ground/ground.h"
#include "render/options.h"

namespace cydonia::render {

// Maps that are computed once for a land and used by all frames that show it. Each covers
// the whole land, row 0 in the north. The two maps of the ground have several pixels a
// sample; the albedo, which only write_pov_assets() uses, is by far the largest.
struct LandMaps {
    GroundMap ground;
    Field<float> sky_visibility;  // 0 to 1, rounded to the 16 bits that POV-Ray reads
};

LandMaps land_maps(const Terrain& terrain, const GroundOptions& ground, Quality quality);

}  // namespace cydonia::render
