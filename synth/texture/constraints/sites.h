#pragma once

#include <string>
#include <vector>

#include "field/progress.h"
#include "synth/texture/constraints/geometry.h"
#include "synth/texture/constraints/junctions.h"

namespace cydonia::texture {

// Geometry::sites(). Where two constraints pass within a cell of one another with heights
// more than a cell apart, only the earlier one's sites stay: a warning names both. Warns
// of what lies outside the terrain, too. Throws bad_request for more than kMostSites.
inline constexpr std::size_t kMostSites = 4'000'000;
std::vector<Geometry::Site> sites_of(const std::vector<Spike>& spikes,
                                     const std::vector<Strand>& strands,
                                     const Ground& ground, Progress& progress);

}  // namespace cydonia::texture
