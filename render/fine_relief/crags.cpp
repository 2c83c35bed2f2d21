#include "render/fine_relief/crags.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "field/smoothstep.h"
#include "render/ground/texture_noise.h"

namespace cydonia::render {
namespace {

constexpr double kCragsBegin = 0.16,
                 kCragsFull = 0.75;  // slopes at which roughness is least and is 1
constexpr double kLevel = 1.0 / 16.0;

}  // namespace

Field<float> crags(const Field<float>& heights, double spacing, double wavelength,
                   std::uint64_t seed) {
    const int width = heights.width(), height = heights.height();
    const int step =
        std::max(1, static_cast<int>(std::lround(0.25 * wavelength / spacing)));
    const double per_metre = 0.5 / (step * spacing);
    Field<float> result(width, height);
    parallel_for(height, 8, [&](int y) {
        const int north = std::max(y - step, 0), south = std::min(y + step, height - 1);
        for (int x = 0; x < width; ++x) {
            const int west = std::max(x - step, 0), east = std::min(x + step, width - 1);
            const double a = (heights(east, y) - heights(west, y)) * per_metre;
            const double b = (heights(x, south) - heights(x, north)) * per_metre;
            const double rough =
                kLevel + (1.0 - kLevel) * smoothstep(kCragsBegin, kCragsFull,
                                                     std::sqrt(a * a + b * b));
            const double e = (x + 0.5) * spacing, s = (y + 0.5) * spacing;
            const double noise = texture_noise(e, s, wavelength, seed);
            const double where = texture_noise(e, s, 9.0 * wavelength, seed + 1);
            const double ridged = 0.6 - 2.0 * std::fabs(noise);
            const double share = std::clamp(0.5 + 2.0 * where, 0.0, 1.0);
            result(x, y) = static_cast<float>(rough * (noise + share * (ridged - noise)));
        }
    });
    return result;
}

}  // namespace cydonia::render
