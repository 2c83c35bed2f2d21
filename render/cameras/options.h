#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/enum_names.h"
#include "field/length.h"
#include "field/source.h"
#include "field/sun.h"

namespace cydonia::render {

// The position of a camera on a path at one frame. Heights are above the ground below the
// points.
struct CameraKey {
    double frame = 0.0;
    std::array<Length, 3> eye{};     // x east, y north, z above the ground there
    std::array<Length, 3> target{};  // x east, y north, z above the ground there
};

// A camera as a scene describes it; placed over a terrain by render/cameras/cameras.h.
struct CameraOptions {
    enum class Kind {
        kOverhead,  // orthographic, straight down, north up, the whole extent
        kOblique,   // looks along `azimuth` from above, the whole extent in view
        kOrbit,     // at `distance` around the centre of the land
        kLookAt,    // `eye` and `target` given
        kStand,     // on the ground at `position`, as a person stands there
        kPath,      // through `keys`
        kDrawing,   // as the camera whose frame was drawn over
    };
    std::string name;  // file-name-safe, unique in a scene
    Kind kind = Kind::kOblique;
    double azimuth = radians(180.0);  // where the camera stands, from the centre; radians
    double elevation = radians(20.0);  // above the horizon, seen from the centre; radians
    std::optional<Length> distance;  // from the centre; default: the land fills the frame
    std::array<Length, 3> eye{};     // x east, y north, z above the ground there
    std::array<Length, 3> target{};  // x east, y north, z above the ground there

    std::array<Length, 2> position{};  // kStand: x east, y north
    Length eye_height = metres(1.8);   // kStand: above the ground there
    double heading = 0.0;              // kStand: the viewing direction unless there is a
    double pitch = 0.0;                // `target`: from north, and upwards; radians
    bool looks_at_target = false;

    std::optional<Source> drawing;  // field/svg_camera.h
    std::vector<CameraKey> keys;    // kPath: at least two, in order of frames
    bool eased = true;              // a path starts from rest and comes to rest

    // A sequence sets these for each frame.
    double frame = 0.0;  // where on its path the camera is
    double turn = 0.0;   // around the land, or what it looks at; clockwise; radians

    // The lens. A focal length overrides the field of view.
    double field_of_view = radians(30.0);  // across the frame's width; radians
    std::optional<double> focal_length;    // millimetres
    double sensor_width = 36.0;            // millimetres
    std::optional<double> f_stop;  // focal length over opening; default: all sharp
    std::optional<Length> focus_distance;        // along the view; default: to the target
    std::optional<std::array<Length, 3>> focus;  // a point as `target` is, instead

    double shutter_angle = radians(180.0);  // open for this share of a frame's time
    int shutter_samples = 1;                // moments averaged over it; 1: no motion blur
    double exposure = 0.0;                  // EV, added to the scene's

    std::array<int, 2> size{1920,
                            1080};  // pixels at final quality; draft a third, preview two
    std::optional<Sun> sun;         // default: the scene's
};

inline constexpr Name<CameraOptions::Kind> kCameraKinds[] = {
    {"overhead", CameraOptions::Kind::kOverhead},
    {"oblique", CameraOptions::Kind::kOblique},
    {"orbit", CameraOptions::Kind::kOrbit},
    {"look_at", CameraOptions::Kind::kLookAt},
    {"stand", CameraOptions::Kind::kStand},
    {"path", CameraOptions::Kind::kPath},
    {"drawing", CameraOptions::Kind::kDrawing}};
static_assert(is_complete(kCameraKinds, CameraOptions::Kind::kDrawing));

}  // namespace cydonia::render
