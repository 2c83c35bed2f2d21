#pragma once

#include "field/terrain.h"
#include "synth/distance/graph.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// Rusnell 2009, section 6.2: lays the seas and lakes of the options into finished land.
// From each drawn shore, which may pass between samples, the bed falls inwards along its
// profile over the graph's edges. The land outside rises from the surface at most at
// shore_slope, and where it would lie lower, a low bank holds the water. Adds to
// terrain.water; where waters overlap, the later one holds. Throws bad_request for a
// picture in which nothing, or everything, is water.
void lay_water(Terrain& terrain, const Options& options, const Graph& graph);

}  // namespace cydonia::distance
