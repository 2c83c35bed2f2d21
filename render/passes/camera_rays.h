#pragma once

#include "field/camera.h"

namespace cydonia::render {

// What a camera's pinhole sees along one line, world metres.
struct Ray {
    Vec3 from;
    Vec3 direction;  // of length 1
};

// The rays of a camera's frame, to the pixel those of the POV-Ray camera that render/pov
// writes. A lens (depth of field) is left out: a pass is sharp.
class CameraRays {
  public:
    explicit CameraRays(const Camera& camera);

    // Through a point of the frame, in pixels: (0, 0) is its upper left corner, x grows
    // to the right, y down, and pixel (i, j) has its centre at (i + 0.5, j + 0.5).
    Ray through(double x, double y) const;

    // The same the other way: where a world point is in the frame, pixels, and how far
    // along the view's axis (negative behind the camera), metres.
    struct FramePoint {
        double x, y, depth;
    };
    FramePoint project(const Vec3& point) const;

    int width() const { return width_; }
    int height() const { return height_; }
    const Vec3& forward() const { return axes_.forward; }

  private:
    bool parallel_;
    int width_, height_;
    CameraAxes axes_;
    double pixel_;  // its side
};

}  // namespace cydonia::render
