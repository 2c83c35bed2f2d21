#include "render/shadow/shading.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"

namespace cydonia::render {

Field<float> shading(const Field<float>& heights, double spacing, const Sun& sun) {
    const Vec3 light = direction_to(sun);
    const int w = heights.width(), h = heights.height();
    Field<float> result(w, h);
    parallel_for(h, 16, [&](int y) {
        const int north = std::max(0, y - 1), south = std::min(h - 1, y + 1);
        for (int x = 0; x < w; ++x) {
            const int west = std::max(0, x - 1), east = std::min(w - 1, x + 1);
            const double gx =
                (heights(east, y) - heights(west, y)) / ((east - west) * spacing);
            const double gy =
                (heights(x, north) - heights(x, south)) / ((south - north) * spacing);
            const double lit = (light.z - gx * light.x - gy * light.y) /
                               std::sqrt(1.0 + gx * gx + gy * gy);
            result(x, y) = static_cast<float>(std::max(0.0, lit));
        }
    });
    return result;
}

}  // namespace cydonia::render
