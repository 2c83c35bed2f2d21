#pragma once

#include "field/image.h"
#include "render/sky/options.h"

namespace cydonia::render {

// The air before the land: even below `base`, above it thinning out as
// 1 / (1 + height / kHazeHeight)^2. That is POV-Ray's ground fog, one extinction for all
// colours; what sends back is in render/sky/sky.h.
inline constexpr double kHazeHeight = 1200.0;  // metres, of all aerosols

// Where 2 % of a contrast is left at the lowest ground (Koschmieder), metres; 0: no haze.
// By default that of the sky's own air 2000 m above the sea, as over mountains: films
// take clear days. `width` of the land.
double visibility(const SkyOptions& sky, const HazeOptions& haze, double width);

// The share of light that passes from an eye so far above the lowest ground along a
// direction of which `up` is the sine, metres.
double through_haze(double visibility, double eye, double up, double distance);

// The dome as it stands behind the haze: seen through it from `eye`, it is the one given
// (both as sky_dome's), to a degree above the horizon, where haze hides all. For
// renderers whose fog lies over the sky too, which has its air already.
Field<Rgb> behind_haze(const Field<Rgb>& dome, const Rgb& light, double visibility,
                       double eye);

}  // namespace cydonia::render
