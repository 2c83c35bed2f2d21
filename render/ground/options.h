#pragma once

#include <array>
#include <optional>

#include "field/length.h"
#include "render/ground/look.h"

namespace cydonia::render {

struct WaterOptions {
    Length level;  // metres above the terrain's zero
};

struct GroundOptions {
    Look look = {};  // one earth everywhere; a scene's is read from config/looks
    std::optional<Length> snow_line;                  // default: the look's
    std::optional<std::array<double, 2>> rock_slope;  // radians; default: the look's
};

}  // namespace cydonia::render
