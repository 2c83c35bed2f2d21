#pragma once

#include <optional>

#include "field/image.h"
#include "field/length.h"

namespace cydonia::render {

enum class Clouds { kNone, kCirrus, kBroken, kOvercast };

struct SkyOptions {
    double turbidity = 2.5;  // of Preetham et al. 1999: 1.9 (clear) to 10 (hazy)
    double fill = 1.0;       // factor of skylight; 1 is physical, more brightens shadows
    double ground_albedo =
        0.2;          // of all the land around, which lights the air from below
    bool air = true;  // false: a black sky, and the sun as outside the air
    // Coarse mineral dust in thin air, as on Mars: the albedo of a grain, linear Rec.709.
    // Without it air and haze are as on earth.
    std::optional<Rgb> dust{};
    Clouds clouds = Clouds::kNone;
    // Whether broken clouds cast shadows on the land. Default: if it shows no shadow
    // image.
    std::optional<bool> cloud_shadows{};
    // The lit share of the moon's disc. Above 0 it is night and the moon takes the
    // position of the scene's sun. A colour of 1 is then that of a white sheet under a
    // full moon outside the air, 400,000 times less than by day.
    double moon = 0.0;
};

struct HazeOptions {
    // The distance at which 2 % of a contrast is left at the lowest ground; 0: no haze.
    // Default: by the turbidity.
    std::optional<Length> visibility{};
};

}  // namespace cydonia::render
