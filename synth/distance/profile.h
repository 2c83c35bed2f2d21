#pragma once

#include <vector>

#include "synth/distance/descent.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// The cost line of every profile of the options, as descent_of() makes it.
std::vector<Descent> descents_of(const Options& options, double sea_level, double width);

// Rusnell 2009, section 3.3.1. A run of points with the same height counts as one slope,
// its mean. Slopes below minimum_scale * mean_edge_weight are interpolated from the
// nearest steeper ones on both sides. `width` is the terrain's in metres. Throws
// bad_request for a profile that rises, is flat or has fewer than two points, and says
// where.
Descent descent_of(const Profile& profile, double sea_level, double mean_edge_weight,
                   double minimum_scale, double width);

}  // namespace cydonia::distance
