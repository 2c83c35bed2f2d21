#pragma once

#include <array>

#include "field/source.h"

namespace cydonia::dem {

// A window of a real elevation model as the land.
struct Options {
    Source source;  // what field/dem.h reads
    // Of the window's middle in the model, from its south-west corner, as shares of it.
    std::array<double, 2> position{0.5, 0.5};
    // false: the window is as large as the terrain, metre for metre. true: the largest
    // window of the terrain's proportions, stretched over it; heights stay as they are.
    bool fit = false;
    double vertical_scale = 1.0;  // times the heights, at the end
};

}  // namespace cydonia::dem
