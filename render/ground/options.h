#pragma once

#include <array>

#include "field/length.h"

namespace cydonia::render {

struct WaterOptions {
    Length level;  // metres above the terrain's zero
};

struct GroundOptions {
    Length snow_line = metres(1e9);                                  // none by default
    std::array<double, 2> rock_slope{radians(30.0), radians(40.0)};  // radians
};

}  // namespace cydonia::render
