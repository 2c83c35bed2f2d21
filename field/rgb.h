#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "field/image.h"

// Arithmetic of linear colours.
namespace cydonia {

inline Rgb operator+(const Rgb& a, const Rgb& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Rgb operator*(const Rgb& a, const Rgb& b) {
    return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
inline Rgb operator*(double s, const Rgb& c) {
    const auto f = static_cast<float>(s);
    return {f * c[0], f * c[1], f * c[2]};
}
// Interpolates from a, at t = 0, to b, at t = 1.
inline Rgb mixed(const Rgb& a, const Rgb& b, double t) {
    const auto f = static_cast<float>(t);
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
}

// The sRGB level (IEC 61966-2-1) of linear light from 0 to 1.
inline std::uint8_t srgb_level(double linear) {
    const double v = std::clamp(linear, 0.0, 1.0);
    const double encoded =
        v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

}  // namespace cydonia
