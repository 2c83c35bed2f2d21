#pragma once

#include <string>
#include <vector>

#include "field/progress.h"
#include "synth/texture/constraints/geometry.h"
#include "synth/texture/constraints/junctions.h"

namespace cydonia::texture {

// The result of Geometry::sites(). Where two constraints pass within a cell of each other
// and their heights are more than a cell apart, only the sites of the earlier one are
// kept, and a warning names both. Also warns of constraints outside the terrain. Throws
// bad_request for more than kMostSites.
inline constexpr std::size_t kMostSites = 4'000'000;
std::vector<Geometry::Site> sites_of(const std::vector<PointConstraint>& points,
                                     const std::vector<CurveConstraint>& curves,
                                     const geometry::Ground& ground, Progress& progress);

}  // namespace cydonia::texture
