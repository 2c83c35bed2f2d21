#include "render/scene/shot.h"

#include <algorithm>
#include <cmath>

#include "render/sky/haze.h"
#include "render/sky/sky.h"

namespace cydonia::render {

bool has_haze(const Shot& shot) {
    return shot.camera.projection == Camera::Projection::kPerspective &&
           visibility(shot.options.sky, shot.options.haze, 1.0) > 0.0;
}

Rgb haze_light(const Shot& shot) {
    constexpr double kBeyond = 2.0;  // the haze reaches twice as far as the target
    const double kHorizon = radians(0.7);
    const Camera& camera = shot.camera;
    const Vec3 view = camera.target - camera.eye;
    const double half_height =
        std::atan(std::tan(0.5 * camera.field_of_view) * camera.height / camera.width);
    const double highest = std::asin(view.z / length(view)) + half_height;
    const bool sees_horizon = highest >= kHorizon;
    return air_light(shot.sun, shot.options.sky, std::atan2(view.x, view.y),
                     camera.field_of_view, std::clamp(kBeyond * length(view), 5e3, 80e3),
                     sees_horizon ? kHorizon : highest,
                     sees_horizon ? 0.0 : std::max(0.0, -view.z));
}

}  // namespace cydonia::render
