#pragma once

#include "field/length.h"

namespace cydonia::render {

enum class Clouds { kNone, kCirrus, kBroken, kOvercast };

struct SkyOptions {
    double turbidity = 2.5;  // 1.9 (clear) to 10 (hazy), Preetham's
    double fill = 1.0;  // sky light times this; 1 is physical, more opens the shadows
    double ground_albedo =
        0.2;  // of the land all around, which lights the air from below
    Clouds clouds = Clouds::kNone;
    // The lit share of the moon's disc. Above 0 it is night: the moon stands where the
    // scene puts the sun, and 1 is what a white sheet sends back of a full moon outside
    // the air, 400,000 times less than by day.
    double moon = 0.0;
};

struct HazeOptions {
    Length visibility = of_width(12.0);  // distance at which haze takes over; 0: none
};

}  // namespace cydonia::render
