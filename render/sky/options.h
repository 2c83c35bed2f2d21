#pragma once

#include "field/length.h"

namespace cydonia::render {

struct SkyOptions {
    double turbidity = 2.5;  // 1.9 (clear) to 10 (hazy)
    double fill = 1.5;  // sky light times this; 1 is physical, more opens the shadows
};

struct HazeOptions {
    Length visibility = of_width(12.0);  // distance at which haze takes over; 0: none
};

}  // namespace cydonia::render
