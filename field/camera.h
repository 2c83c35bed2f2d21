#pragma once

#include <cmath>

#include "field/vec.h"

namespace cydonia {

// A camera and where it stands, in world metres.
struct Camera {
    enum class Projection { kPerspective, kOrthographic };

    Projection projection = Projection::kPerspective;
    Vec3 eye;
    Vec3 target;
    Vec3 up{0.0, 0.0, 1.0};
    double field_of_view = 0.6;  // radians across the frame's width; perspective only
    double frame_width = 1.0;    // metres across the frame's width; orthographic only
    int width = 640;             // pixels
    int height = 360;
    // The lens, in perspective only: the diameter of its opening, where 0 is a pinhole
    // that draws everything sharply, and the distance of the sharp plane, measured along
    // the view.
    double aperture = 0.0;        // metres
    double focus_distance = 1.0;  // metres
};

// A camera's own directions, each of length 1.
struct CameraAxes {
    explicit CameraAxes(const Camera& camera)
        : eye(camera.eye),
          forward(normalized(camera.target - camera.eye)),
          right(normalized(cross(forward, camera.up))),
          up(cross(right, forward)) {}
    // A point as the camera sees it: to the right, up and forward, metres.
    Vec3 operator()(const Vec3& point) const {
        const Vec3 d = point - eye;
        return {dot(d, right), dot(d, up), dot(d, forward)};
    }
    Vec3 eye, forward, right, up;
};

// The width of a pixel: in metres for an orthographic camera, in metres at a distance of
// one metre for a perspective one.
inline double pixel_side(const Camera& camera) {
    const bool parallel = camera.projection == Camera::Projection::kOrthographic;
    return (parallel ? camera.frame_width : 2.0 * std::tan(0.5 * camera.field_of_view)) /
           camera.width;
}

}  // namespace cydonia
