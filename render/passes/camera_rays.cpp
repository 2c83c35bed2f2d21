#include "render/passes/camera_rays.h"

namespace cydonia::render {
CameraRays::CameraRays(const Camera& camera)
    : parallel_(camera.projection == Camera::Projection::kOrthographic),
      width_(camera.width),
      height_(camera.height),
      axes_(camera),
      pixel_(pixel_side(camera)) {}

Ray CameraRays::through(double x, double y) const {
    const Vec3 aside = pixel_ * (x - 0.5 * width_) * axes_.right +
                       pixel_ * (0.5 * height_ - y) * axes_.up;
    if (parallel_) return {axes_.eye + aside, axes_.forward};
    return {axes_.eye, normalized(axes_.forward + aside)};
}

CameraRays::FramePoint CameraRays::project(const Vec3& point) const {
    const Vec3 seen = axes_(point);
    const double scale = pixel_ * (parallel_ ? 1.0 : seen.z);
    return {0.5 * width_ + seen.x / scale, 0.5 * height_ - seen.y / scale, seen.z};
}

}  // namespace cydonia::render
