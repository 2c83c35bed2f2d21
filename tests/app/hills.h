#pragma once

#include <cmath>

#include "field/terrain.h"

namespace cydonia::test {

// A little elevation model to make land of.
inline Terrain hills() {
    Terrain hills{Field<float>(96, 80), 10.0, {}, {}, {}};
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 96; ++x)
            hills.heights(x, y) = 300.0f + 40.0f * std::sin(0.21f * float(x)) +
                                  25.0f * std::sin(0.17f * float(y) + 0.05f * float(x));
    return hills;
}

}  // namespace cydonia::test
