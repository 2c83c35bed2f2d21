#pragma once

#include <cstdint>
#include <vector>

#include "synth/context.h"
#include "synth/genetic/map/boundary.h"
#include "synth/genetic/options.h"

namespace cydonia::genetic {

// The outlines of one region, in metres east and north of the terrain's south-west
// corner.
struct Drawn {
    std::vector<std::vector<Point2>> outlines;  // the first point is not repeated
};

// The map's outlines over the terrain. Nearly equal corners are merged, and boundaries
// between regions are refined; neighbours share them, so that there are no gaps.
// Boundaries along the window's frame stay straight. Throws bad_request, which names the
// region, for outlines that cross themselves or enclose nothing.
std::vector<Drawn> drawn_outlines(const MapOptions& map, const LibraryOptions& library,
                                  const Extent& extent, std::uint64_t seed);

}  // namespace cydonia::genetic
