#pragma once

#include <array>
#include <optional>

#include "field/length.h"
#include "render/ground/look.h"

namespace cydonia::render {

struct WaterOptions {
    Length level;  // metres above the terrain's zero
};

// What surrounds the land. By default copies of the land continue it. Level country does
// where the land shows a shadow image, which must not appear twice, or meets the sea.
enum class Around {
    kLevel,  // country at the height of the lowest border
    kLand,   // copies of the land, mirrored at its borders; they cast no shadow on it
};

struct GroundOptions {
    Look look = {};  // the default is one material everywhere; scenes read theirs from
                     // config/looks
    std::optional<Around> around;
    std::optional<Length> snow_line;                  // default: the look's
    std::optional<std::array<double, 2>> rock_slope;  // radians; default: the look's
};

}  // namespace cydonia::render
