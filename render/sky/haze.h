#pragma once

#include "field/image.h"
#include "render/sky/options.h"

namespace cydonia::render {

// The haze in front of the land. Its density is constant below `base` and falls above it
// as 1 / (1 + height / kHazeHeight)^2, as in POV-Ray's ground fog. All colours have the
// same extinction; the colour of haze is in render/sky/sky.h.
inline constexpr double kHazeHeight = 1200.0;  // metres, of all aerosols

// The distance at which 2 % of a contrast is left at the lowest ground (Koschmieder),
// metres, or 0 for no haze. The default is that of the sky's own air 2000 m above the
// sea, as over mountains. `width` is that of the land.
double visibility(const SkyOptions& sky, const HazeOptions& haze, double width);

// The share of light that passes through the haze over a distance, from an eye above the
// lowest ground (metres) along a direction whose elevation has the sine `up`.
double through_haze(double visibility, double eye, double up, double distance);

// The dome that looks like the given one when it is seen through the haze from `eye`
// metres above the lowest ground, for renderers whose fog covers the sky too. Both are as
// sky_dome's. It holds down to a degree above the horizon, below which haze hides all.
Field<Rgb> behind_haze(const Field<Rgb>& dome, const Rgb& light, double visibility,
                       double eye);

}  // namespace cydonia::render
