#pragma once

#include <array>

#include "field/source.h"

namespace cydonia::dem {

// Takes a window of a real elevation model as the land.
struct Options {
    Source source;  // an elevation model in any format that field/dem.h reads
    // The window's centre, as shares of the model's width and depth from its south-west
    // corner.
    std::array<double, 2> position{0.5, 0.5};
    // false: the window is as large as the terrain, in metres. true: the largest window
    // with the terrain's proportions is stretched over the terrain; heights are not
    // scaled.
    bool fit = false;
    double vertical_scale = 1.0;  // factor of the heights
};

}  // namespace cydonia::dem
