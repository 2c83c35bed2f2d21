#pragma once

#include "field/terrain.h"
#include "synth/distance/graph.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// Rusnell 2009, section 6.2: lays the seas and lakes of the options into finished land.
// From each drawn shore, which may pass between samples, the bed falls away inwards along
// its profile, over the graph's edges. The land outside keeps within shore_slope of the
// surface, and where it would lie lower a low bank keeps the water in. Adds to
// terrain.water; of waters that overlap the later holds. Throws bad_request for a picture
// in which nothing, or everything, is water.
void lay_water(Terrain& terrain, const Options& options, const Graph& graph);

}  // namespace cydonia::distance
