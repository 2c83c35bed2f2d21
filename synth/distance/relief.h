#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "synth/distance/descent.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// Fine relief of a profile's cost line. The ends of the line stay, and it keeps rising
// strictly.

// Adds waves to the slope: none when `detail` is 0, and never to level ground when it is
// below 1. There are four random waves: the longest has `longest` metres along the slope,
// and each further one is half as long.
std::vector<CostPoint> with_detail(std::span<const CostPoint> line, double detail,
                                   double longest, std::uint64_t seed);

// Cuts the slope into layers of equal height from the top, each a cliff over a ledge.
std::vector<CostPoint> with_strata(std::span<const CostPoint> line,
                                   const Profile::Strata& strata);

}  // namespace cydonia::distance
