#include <fmt/core.h>

#include <cmath>

#include "render/pov/pieces.h"

namespace cydonia::render::pov {
namespace {

// POV-Ray scatters rays over less than half of its `aperture`. With this factor they
// spread as over a uniform disc as wide as the lens (measured in lens_test.cpp).
constexpr double kApertureOfLens = 2.2;

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

// Depth of field. With variance 0 POV-Ray takes all rays for every pixel, at positions
// that depend on the pixel only, so that frames are equal for any number of threads.
std::string lens(const Camera& c, Quality quality) {
    if (c.aperture <= 0.0) return "";
    const int rays = quality == Quality::kDraft ? 19 : 37;
    const Vec3 sharp = c.eye + c.focus_distance * normalized(c.target - c.eye);
    return fmt::format(R"(
    // A lens {} mm wide.
    aperture {} * {} / Unit
    focal_point At({})
    blur_samples {} variance 0)",
                       number(1e3 * c.aperture), number(kApertureOfLens),
                       number(c.aperture), numbers(sharp), rays);
}

std::string perspective(const Camera& c, Quality quality) {
    return fmt::format(R"(camera {{
    location At({})
    sky Towards({})
    up y right image_width / image_height * x
    angle {} // across the frame's width
    look_at At({}){}
}}

)",
                       numbers(c.eye), numbers(c.up), number(degrees(c.field_of_view)),
                       numbers(c.target), lens(c, quality));
}

}  // namespace

std::string camera(const Shot& shot) {
    const Camera& c = shot.camera;
    return c.projection == Camera::Projection::kOrthographic
               ? orthographic(c)
               : perspective(c, shot.quality);
}

}  // namespace cydonia::render::pov
