#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "field/field.h"
#include "field/random.h"
#include "field/sun.h"

// Land for the shadow tests, and a slow, independent answer to what the caster must say.
namespace cydonia::render {

using Mask = Field<std::uint8_t>;

inline Sun sun_at(double azimuth, double elevation) {
    return {radians(azimuth), radians(elevation)};
}

inline std::size_t area(const Mask& mask) {
    return static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 1));
}

// Heights of a function of metres east and north of the south-west corner.
template <class Function>
Field<float> land(int width, int height, double spacing, const Function& z) {
    Field<float> result(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            result(x, y) =
                static_cast<float>(z((x + 0.5) * spacing, (height - y - 0.5) * spacing));
    return result;
}

// Octaves of interpolated random values, rough down to the single cell.
inline Field<float> fractal(int width, int height, float relief, std::uint64_t seed) {
    Field<float> result(width, height);
    for (int step = 32; step >= 1; step /= 2)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const auto value = [&](int i, int j) {
                    return signed_unit(
                        hash_of({seed, static_cast<std::uint64_t>(step),
                                 static_cast<std::uint64_t>(x / step + i),
                                 static_cast<std::uint64_t>(y / step + j)}));
                };
                const double u = static_cast<double>(x % step) / step;
                const double v = static_cast<double>(y % step) / step;
                const double z = (1 - v) * ((1 - u) * value(0, 0) + u * value(1, 0)) +
                                 v * ((1 - u) * value(0, 1) + u * value(1, 1));
                result(x, y) += static_cast<float>(relief / 32.0 * step * z);
            }
    return result;
}

// Height of the mesh at a point in cells from the north-west sample, x east and y south:
// squares split along their NW-SE diagonal.
inline double surface(const Field<float>& heights, double x, double y) {
    const int i = std::clamp(static_cast<int>(x), 0, heights.width() - 2);
    const int j = std::clamp(static_cast<int>(y), 0, heights.height() - 2);
    const double u = x - i, v = y - j;
    const double nw = heights(i, j), se = heights(i + 1, j + 1);
    if (u >= v) return (1 - u) * nw + (u - v) * heights(i + 1, j) + v * se;
    return (1 - v) * nw + (v - u) * heights(i, j + 1) + u * se;
}

// How far the mesh rises above the ray from (x, y) to the sun, at its highest: above 0,
// the point is in shadow. Spacing 1. The difference is linear between the lines of the
// triangulation (x, y or x - y whole), so only there it can be highest.
inline double cover(const Field<float>& heights, const Sun& sun, double x, double y) {
    const double east = std::sin(sun.azimuth), south = -std::cos(sun.azimuth);
    const double climb = std::tan(sun.elevation), ground = surface(heights, x, y);
    double highest = -1e9;
    const auto march = [&](double from, double speed) {
        if (std::abs(speed) < 1e-9) return;
        double line = speed > 0 ? std::floor(from) + 1.0 : std::ceil(from) - 1.0;
        for (;; line += speed > 0 ? 1.0 : -1.0) {
            const double t = (line - from) / speed;
            const double px = x + t * east, py = y + t * south;
            if (px < -1e-9 || py < -1e-9 || px > heights.width() - 1 + 1e-9 ||
                py > heights.height() - 1 + 1e-9)
                return;
            highest = std::max(highest, surface(heights, px, py) - ground - t * climb);
        }
    };
    march(x, east);
    march(y, south);
    march(x - y, east - south);
    return highest;
}

}  // namespace cydonia::render
