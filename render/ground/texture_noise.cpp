#include "render/ground/texture_noise.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "field/random.h"

namespace cydonia::render {
namespace {

constexpr int kPeriod = 64, kFine = 8, kSide = kPeriod * kFine;

double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

// Gradient noise after Perlin 2002 on a periodic lattice.
double periodic_noise(double x, double y) {
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double u = x - i, v = y - j;
    const auto corner = [&](int di, int dj) {
        const auto h =
            hash_of({key("texture noise"), static_cast<std::uint64_t>((i + di) % kPeriod),
                     static_cast<std::uint64_t>((j + dj) % kPeriod)});
        const double a = 2.0 * std::numbers::pi * unit(h);
        return std::cos(a) * (u - di) + std::sin(a) * (v - dj);
    };
    const double s = fade(u), t = fade(v);
    return std::numbers::sqrt2 * std::lerp(std::lerp(corner(0, 0), corner(1, 0), s),
                                           std::lerp(corner(0, 1), corner(1, 1), s), t);
}

const std::vector<float>& table() {
    static const std::vector<float> values = [] {
        std::vector<float> v(static_cast<std::size_t>(kSide) * kSide);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                v[static_cast<std::size_t>(y) * kSide + x] = static_cast<float>(
                    periodic_noise(double(x) / kFine, double(y) / kFine));
        return v;
    }();
    return values;
}

// The value at a point in table cells.
double looked_up(const float* values, double x, double y) {
    const double fx = std::floor(x), fy = std::floor(y);
    const double u = x - fx, v = y - fy;
    const int i = static_cast<int>(static_cast<std::int64_t>(fx)) & (kSide - 1);
    const int j = static_cast<int>(static_cast<std::int64_t>(fy)) & (kSide - 1);
    const int i1 = (i + 1) & (kSide - 1), j1 = (j + 1) & (kSide - 1);
    const float *a = values + j * kSide, *b = values + j1 * kSide;
    return (1.0 - v) * ((1.0 - u) * a[i] + u * a[i1]) +
           v * ((1.0 - u) * b[i] + u * b[i1]);
}

}  // namespace

double texture_noise(double east, double south, double wavelength, std::uint64_t seed) {
    const float* values = table().data();
    const std::uint64_t shift = mix(seed);
    const double dx = static_cast<double>(shift & (kSide - 1));
    const double dy = static_cast<double>((shift >> 16) & (kSide - 1));
    const double x = kFine * east / wavelength, y = kFine * south / wavelength;
    constexpr double kCos = 0.79863551, kSin = 0.60181502;  // 37 degrees
    return looked_up(values, x + dx, y + dy) +
           0.5 * looked_up(values, 2.03 * (kCos * x - kSin * y) + dy,
                           2.03 * (kSin * x + kCos * y) + dx);
}

}  // namespace cydonia::render
