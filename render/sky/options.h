#pragma once

#include <optional>

#include "field/image.h"
#include "field/length.h"

namespace cydonia::render {

enum class Clouds { kNone, kCirrus, kBroken, kOvercast };

struct SkyOptions {
    double turbidity = 2.5;  // 1.9 (clear) to 10 (hazy), Preetham's
    double fill = 1.0;  // sky light times this; 1 is physical, more opens the shadows
    double ground_albedo =
        0.2;          // of the land all around, which lights the air from below
    bool air = true;  // false: a black sky and the sun as it is outside the air
    // Of coarse mineral dust in thin air, as on Mars: the share of each colour that a
    // grain sends on, linear Rec.709. Without it: air and haze as on earth.
    std::optional<Rgb> dust{};
    Clouds clouds = Clouds::kNone;
    // Of broken clouds on the land; default: where no shadow image is asked for.
    std::optional<bool> cloud_shadows{};
    // The lit share of the moon's disc. Above 0 it is night: the moon stands where the
    // scene puts the sun, and 1 is what a white sheet sends back of a full moon outside
    // the air, 400,000 times less than by day.
    double moon = 0.0;
};

struct HazeOptions {
    // Where 2 % of a contrast is left, at the lowest ground; default: as the turbidity
    // makes it, 0: none.
    std::optional<Length> visibility{};
};

}  // namespace cydonia::render
