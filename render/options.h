#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/image.h"
#include "field/length.h"
#include "field/source.h"
#include "field/sun.h"

namespace cydonia::render {

enum class Quality { kDraft, kPreview, kFinal };

// A camera as a scene describes it; placed over a terrain by render/cameras.h.
struct CameraOptions {
    enum class Kind {
        kOverhead,  // orthographic, straight down, north up, the whole extent
        kOblique,   // looks along `azimuth` from above, the whole extent in view
        kOrbit,     // at `distance` around the centre of the land
        kLookAt,    // `eye` and `target` given
    };
    std::string name;  // file-name-safe, unique in a scene
    Kind kind = Kind::kOblique;
    double azimuth = radians(180.0);  // where the camera stands, from the centre; radians
    double elevation = radians(20.0);  // above the horizon, seen from the centre; radians
    std::optional<Length> distance;  // from the centre; default: the land fills the frame
    std::array<Length, 3> eye{};     // x east, y north, z above the ground there
    std::array<Length, 3> target{};  // x east, y north, z above the ground there
    double field_of_view = radians(30.0);  // across the frame's width; radians
    std::array<int, 2> size{1920,
                            1080};  // pixels at final quality; draft a third, preview two
    std::optional<Sun> sun;         // default: the scene's
};

struct SkyOptions {
    double turbidity = 2.5;  // 1.9 (clear) to 10 (hazy)
    double fill = 1.5;  // sky light times this; 1 is physical, more opens the shadows
};

struct HazeOptions {
    Length visibility = of_width(12.0);  // distance at which haze takes over; 0: none
};

struct WaterOptions {
    Length level;  // metres above the terrain's zero
};

struct GroundOptions {
    Length snow_line = metres(1e9);                                  // none by default
    std::array<double, 2> rock_slope{radians(30.0), radians(40.0)};  // radians
};

struct ColourOptions {
    std::optional<Source> config;  // default: $OCIO, else the shipped config
    std::string display;           // default: the config's
    std::string view;
    // EV above or below what each frame gets by itself: its 90th percentile of light
    // shown as 0.6 of white before the view, six stops up or down at most. The EXR has
    // none of it.
    double exposure = 0.0;
};

struct Options {
    std::optional<Sun> sun;  // default: the first shadow image's; else 315, 35 degrees
    std::vector<CameraOptions> cameras;  // default: overhead and oblique
    SkyOptions sky;
    HazeOptions haze;
    std::optional<WaterOptions> water;
    GroundOptions ground;
    ColourOptions colour;
};

}  // namespace cydonia::render
