#pragma once

#include <vector>

#include "field/image.h"

namespace cydonia::render {

// The exposure in EV that a frame of ACEScg needs to put the 90th percentile of its light
// at 0.5 of white before the view, between -6 and 6. It is 0 for a black frame.
double own_stops(const Field<Rgb>& acescg);

// One exposure for all frames of a sequence: the median of the frames' own exposures. The
// sequence then does not flicker, and no single frame (the sun behind a ridge) changes
// it. Needs at least one frame; every tenth frame is enough.
double steady_stops(std::vector<double> own);

}  // namespace cydonia::render
