#pragma once

#include <vector>

#include "synth/distance/descent.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// The cost line of every profile of the options. See descent_of.
std::vector<Descent> descents_of(const Options& options, double sea_level, double width);

// Rusnell 2009, section 3.3.1. Points with the same height count as one slope, the mean
// over their run; slopes below minimum_scale * mean_edge_weight are interpolated from the
// nearest steeper ones on both sides. `width` is the terrain's, metres. Throws
// bad_request, saying where, for a profile that rises, is flat, or has fewer than two
// points.
Descent descent_of(const Profile& profile, double sea_level, double mean_edge_weight,
                   double minimum_scale, double width);

}  // namespace cydonia::distance
