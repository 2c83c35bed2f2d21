#pragma once

#include <array>
#include <optional>
#include <string>

#include "field/length.h"
#include "field/sun.h"

namespace cydonia::render {

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

}  // namespace cydonia::render
