#pragma once

#include "field/terrain.h"
#include "synth/distance/graph.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// Rusnell 2009, section 6.2: lays the seas and lakes of the options into finished land.
// From each drawn shore the bed falls away inwards along its profile, over the graph's
// edges, and the land outside keeps within shore_slope of the surface. Adds to
// terrain.water. Throws bad_request for a picture in which nothing, or everything, is
// water.
void lay_water(Terrain& terrain, const Options& options, const Graph& graph);

}  // namespace cydonia::distance
