#pragma once

#include <functional>

namespace cydonia::texture {

// Where the plane lies: metres, from the terrain's south-west corner.
struct Ground {
    double width = 0.0, depth = 0.0;  // of the terrain, metres
    double spacing = 1.0;             // of level 0, metres
};

// Height of the unconstrained land, metres, at metres from the south-west corner.
using HeightAt = std::function<double(double x, double y)>;

}  // namespace cydonia::texture
