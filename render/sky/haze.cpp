#include "render/sky/haze.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/parallel.h"
#include "render/sky/atmosphere.h"

namespace cydonia::render {
namespace {

constexpr double kKoschmieder = 3.912;  // -log 0.02
constexpr double kLand = 2000.0;        // metres above the sea
constexpr double kToTheSky = 1e9;       // metres
// The least share of the sky that is recovered; below it half floats would show steps.
constexpr double kLeastThrough = 0.03;
constexpr int kFineRows = 1024;  // haze changes within a tenth of a degree there

}  // namespace

double visibility(const SkyOptions& sky, const HazeOptions& haze, double width) {
    if (!sky.air) return 0.0;
    if (haze.visibility) return haze.visibility->in(width);
    return kKoschmieder / Atmosphere::extinction(sky, kLand);
}

double through_haze(double visibility, double eye, double up, double distance) {
    const double from = eye / kHazeHeight, to = from + distance * up / kHazeHeight;
    const auto below = [](double u) { return u < 0.0 ? u : u / (1.0 + u); };
    const auto here = [](double u) {
        return u < 0.0 ? 1.0 : 1.0 / ((1.0 + u) * (1.0 + u));
    };
    const double mean =
        std::abs(to - from) < 1e-6 ? here(from) : (below(to) - below(from)) / (to - from);
    return std::exp(-kKoschmieder / visibility * mean * distance);
}

Field<Rgb> behind_haze(const Field<Rgb>& dome, const Rgb& light, double visibility,
                       double eye) {
    const int finer = std::max(1, kFineRows / dome.height());
    const int height = finer * dome.height(), width = 2 * height;
    Field<Rgb> behind(width, height);
    parallel_for(height, [&](int y) {
        const double elevation = std::numbers::pi * (0.5 - (y + 0.5) / height);
        const double up = std::sin(std::max(elevation, 0.0));
        const double through =
            std::max(through_haze(visibility, eye, up, kToTheSky), kLeastThrough);
        const double v = std::clamp((y + 0.5) / finer - 0.5, 0.0, dome.height() - 1.0);
        const int j = std::min(static_cast<int>(v), dome.height() - 2);
        for (int x = 0; x < width; ++x) {
            const double u = (x + 0.5) / finer - 0.5 + dome.width();
            const int i = static_cast<int>(u), a = i % dome.width(),
                      b = (i + 1) % dome.width();
            for (std::size_t c = 0; c < 3; ++c) {
                const double f = u - i, g = v - j;
                const double sky =
                    (1.0 - g) * ((1.0 - f) * dome(a, j)[c] + f * dome(b, j)[c]) +
                    g * ((1.0 - f) * dome(a, j + 1)[c] + f * dome(b, j + 1)[c]);
                behind(x, y)[c] = static_cast<float>(
                    std::max(0.0, light[c] + (sky - light[c]) / through));
            }
        }
    });
    return behind;
}

}  // namespace cydonia::render
