#pragma once

#include <vector>

#include "field/image.h"

namespace cydonia::render {

// EV that a frame of ACEScg gets by itself: its 90th percentile of light is shown as 0.5
// of white before the view, six stops up or down at most. 0 for a black frame.
double own_stops(const Field<Rgb>& acescg);

// One exposure for all frames of a sequence, from what each gets by itself: the middle
// one, so that the sequence does not flicker and no single frame (the sun behind a ridge)
// moves it. At least one frame; those of every tenth are as good as all.
double steady_stops(std::vector<double> own);

}  // namespace cydonia::render
