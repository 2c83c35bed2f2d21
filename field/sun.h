#pragma once

#include <cmath>

#include "field/vec.h"

namespace cydonia {

// Where the sun stands, in radians: azimuth clockwise from north, elevation above the
// horizon. Rusnell's tilt theta is pi/2 - elevation.
struct Sun {
    double azimuth = 0.0;
    double elevation = 0.0;
    bool operator==(const Sun&) const = default;
};

// The unit vector from the ground to the sun.
inline Vec3 direction_to(const Sun& sun) {
    const double c = std::cos(sun.elevation);
    return {std::sin(sun.azimuth) * c, std::cos(sun.azimuth) * c,
            std::sin(sun.elevation)};
}

}  // namespace cydonia
