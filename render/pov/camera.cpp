#include <fmt/core.h>

#include <cmath>

#include "render/pov/pieces.h"

namespace cydonia::render::pov {
namespace {

std::string orthographic(const Camera& c) {
    const Vec3 forward = normalized(c.target - c.eye);
    const Vec3 right = normalized(cross(forward, c.up));
    const Vec3 up = cross(right, forward);
    return fmt::format(R"(// From far above, without perspective.
#declare FrameWidth = {}; // metres across
camera {{
    orthographic
    location At({})
    direction Towards({})
    right FrameWidth / Unit * Towards({})
    up FrameWidth / Unit * image_height / image_width * Towards({})
}}

)",
                       number(c.frame_width), numbers(c.eye), numbers(forward),
                       numbers(right), numbers(up));
}

std::string perspective(const Camera& c) {
    return fmt::format(R"(camera {{
    location At({})
    sky Towards({})
    up y right image_width / image_height * x
    angle {} // across the frame's width
    look_at At({})
}}

)",
                       numbers(c.eye), numbers(c.up), number(degrees(c.field_of_view)),
                       numbers(c.target));
}

}  // namespace

double pixel_size(const Camera& camera) {
    if (camera.projection == Camera::Projection::kOrthographic)
        return camera.frame_width / camera.width;
    const double across = 2.0 * std::tan(0.5 * camera.field_of_view);
    return across * length(camera.target - camera.eye) / camera.width;
}

std::string camera(const Camera& camera) {
    return camera.projection == Camera::Projection::kOrthographic ? orthographic(camera)
                                                                  : perspective(camera);
}

}  // namespace cydonia::render::pov
