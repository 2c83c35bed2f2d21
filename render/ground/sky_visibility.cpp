#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/image.h"
#include "field/parallel.h"
#include "render/ground/ground.h"

namespace cydonia::render {

namespace {

constexpr int kLongestSide = 1024;

}  // namespace

Field<float> sky_visibility(const Field<float>& heights, double spacing) {
    const int longest = std::max(heights.width(), heights.height());
    if (longest > kLongestSide) {
        const auto side = [&](int samples) {
            return std::max(1, samples * kLongestSide / longest);
        };
        return sky_visibility(
            resized(heights, side(heights.width()), side(heights.height())),
            spacing * longest / kLongestSide);
    }
    constexpr int kAzimuths = 16;
    constexpr double kFarthest = 160.0;  // cells; hills farther away stand low
    Field<float> visible(heights.width(), heights.height());
    parallel_for(heights.height(), 4, [&](int y) {
        for (int x = 0; x < heights.width(); ++x) {
            double sum = 0.0;
            for (int k = 0; k < kAzimuths; ++k) {
                const double a = 2.0 * std::numbers::pi * (k + 0.5) / kAzimuths;
                const double dx = std::cos(a), dy = std::sin(a);
                double steepest = 0.0;
                for (double t = 1.0; t < kFarthest; t = 1.25 * t + 0.5) {
                    const int i = static_cast<int>(std::floor(x + t * dx + 0.5));
                    const int j = static_cast<int>(std::floor(y + t * dy + 0.5));
                    if (!heights.contains(i, j)) break;
                    const double rise = heights(i, j) - heights(x, y);
                    steepest = std::max(steepest, rise / (t * spacing));
                }
                sum +=
                    1.0 / (1.0 + steepest * steepest);  // cosine squared of the horizon
            }
            visible(x, y) = static_cast<float>(sum / kAzimuths);
        }
    });
    return visible;
}

}  // namespace cydonia::render
