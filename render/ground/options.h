#pragma once

#include <array>
#include <optional>

#include "field/length.h"
#include "render/ground/look.h"

namespace cydonia::render {

struct WaterOptions {
    Length level;  // metres above the terrain's zero
};

// What lies around the land. By itself the land goes on; level country where it promises
// a shadow image, which nothing may show twice, or meets the sea.
enum class Around {
    kLevel,  // country at the height of the lowest border
    kLand,   // the land again, mirrored at its borders; it throws no shadow on the land
};

struct GroundOptions {
    Look look = {};  // one earth everywhere; a scene's is read from config/looks
    std::optional<Around> around;
    std::optional<Length> snow_line;                  // default: the look's
    std::optional<std::array<double, 2>> rock_slope;  // radians; default: the look's
};

}  // namespace cydonia::render
