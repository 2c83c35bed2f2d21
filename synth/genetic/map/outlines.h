#pragma once

#include <cstdint>
#include <vector>

#include "synth/context.h"
#include "synth/genetic/map/boundary.h"
#include "synth/genetic/options.h"

namespace cydonia::genetic {

// A region's outlines in metres east and north of the terrain's south-west corner.
struct Drawn {
    std::vector<std::vector<Point2>> outlines;  // the first point is not repeated
};

// The map's outlines as they lie over the terrain, their corners one where they are
// nearly so, and boundaries between regions refined: neighbours share them, so that there
// are no gaps. What lies along the window's frame stays straight. Throws bad_request,
// naming the region, for outlines that cross themselves or enclose nothing.
std::vector<Drawn> drawn_outlines(const MapOptions& map, const LibraryOptions& library,
                                  const Extent& extent, std::uint64_t seed);

}  // namespace cydonia::genetic
