#pragma once

#include <functional>

namespace cydonia::geometry {

// The ground under a terrain. Positions on it are metres from its south-west corner.
struct Ground {
    double width = 0.0, depth = 0.0;  // of the terrain, metres
    double spacing = 1.0;             // of level 0, metres
};

// The height of the unconstrained land in metres, at a position on the ground.
using HeightAt = std::function<double(double x, double y)>;

}  // namespace cydonia::geometry
