#pragma once

#include "field/image.h"
#include "field/terrain.h"

namespace cydonia::bench {

// Square land from above and from near the ground, looked at from `azimuth` (radians),
// with a sun to its left or right. The same for every land of a size.
struct View {
    double azimuth = 0.0;
    bool sun_on_the_left = true;
};

// A picture of two lands beside each other: A, left, and B; each from above over close
// up. Drawn by POV-Ray with all that a scene's draft has. Nothing but the heights differ.
Field<Rgb8> blind_page(const Terrain& a, const Terrain& b, const View& view);

}  // namespace cydonia::bench
