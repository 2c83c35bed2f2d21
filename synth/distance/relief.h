#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "synth/distance/descent.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// What is cut into a profile's cost line. Its ends stay and it keeps rising strictly.

// Waves of slope: `detail` 0 none, below 1 never to level ground. The longest is
// `longest` metres along the slope, each further one half as long, four in all; by
// `seed`.
std::vector<CostPoint> with_detail(std::span<const CostPoint> line, double detail,
                                   double longest, std::uint64_t seed);

// Layers of equal height, from the top: each a cliff over a ledge.
std::vector<CostPoint> with_strata(std::span<const CostPoint> line,
                                   const Profile::Strata& strata);

}  // namespace cydonia::distance
