#pragma once

#include "field/vec.h"

namespace cydonia {

// A placed camera, in world metres.
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
    // The lens: how wide its opening is, 0 a pinhole that draws all sharp; and how far
    // ahead, measured along the view, the plane stands that is sharp. Perspective only.
    double aperture = 0.0;        // metres
    double focus_distance = 1.0;  // metres
};

}  // namespace cydonia
