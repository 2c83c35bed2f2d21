#pragma once

#include "field/camera.h"

namespace cydonia::render {

// A ray of a pinhole camera, world metres.
struct Ray {
    Vec3 from;
    Vec3 direction;  // of length 1
};

// The rays through a camera's frame, the same to the pixel as those of the POV-Ray camera
// that render/pov writes. There is no depth of field: passes are sharp.
class CameraRays {
  public:
    explicit CameraRays(const Camera& camera);

    // The ray through a point of the frame in pixels: (0, 0) is the upper left corner, x
    // grows to the right, y down, and pixel (i, j) has its centre at (i + 0.5, j + 0.5).
    Ray through(double x, double y) const;

    // The inverse: a world point's position in the frame, pixels, and its distance along
    // the view's axis, metres (negative behind the camera).
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
    double pixel_;  // width of a pixel: metres, or at distance 1 in perspective
};

}  // namespace cydonia::render
