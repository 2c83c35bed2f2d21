#include "render/passes/camera_rays.h"

#include <cmath>

namespace cydonia::render {
namespace {

double side_of_pixel(const Camera& c) {
    const bool parallel = c.projection == Camera::Projection::kOrthographic;
    return (parallel ? c.frame_width : 2.0 * std::tan(0.5 * c.field_of_view)) / c.width;
}

}  // namespace

CameraRays::CameraRays(const Camera& camera)
    : parallel_(camera.projection == Camera::Projection::kOrthographic),
      width_(camera.width),
      height_(camera.height),
      eye_(camera.eye),
      forward_(normalized(camera.target - camera.eye)),
      right_(normalized(cross(forward_, camera.up))),
      up_(cross(right_, forward_)),
      pixel_(side_of_pixel(camera)) {}

Ray CameraRays::through(double x, double y) const {
    const Vec3 aside =
        pixel_ * (x - 0.5 * width_) * right_ + pixel_ * (0.5 * height_ - y) * up_;
    if (parallel_) return {eye_ + aside, forward_};
    return {eye_, normalized(forward_ + aside)};
}

CameraRays::Place CameraRays::place_of(const Vec3& point) const {
    const Vec3 d = point - eye_;
    const double z = dot(d, forward_);
    const double scale = pixel_ * (parallel_ ? 1.0 : z);
    return {0.5 * width_ + dot(d, right_) / scale, 0.5 * height_ - dot(d, up_) / scale,
            z};
}

}  // namespace cydonia::render
