// Gradient noise after K. Perlin, "Improving noise", 2002; fBm after Rusnell 2009,
// Algorithm 1; the ridged multifractal after F. K. Musgrave in "Texturing and Modeling".

#include "field/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "field/parallel.h"
#include "field/random.h"

namespace cydonia {
namespace {

// Sixteen unit gradients: enough directions to hide the lattice, and no sine to compute.
struct Gradient {
    double x, y;
};
constexpr double kA = 0.92387953251128674, kB = 0.38268343236508978;  // cos, sin of pi/8
constexpr double kC = std::numbers::sqrt2 / 2.0;
constexpr std::array<Gradient, 16> kGradients{{{1, 0},
                                               {kA, kB},
                                               {kC, kC},
                                               {kB, kA},
                                               {0, 1},
                                               {-kB, kA},
                                               {-kC, kC},
                                               {-kA, kB},
                                               {-1, 0},
                                               {-kA, -kB},
                                               {-kC, -kC},
                                               {-kB, -kA},
                                               {0, -1},
                                               {kB, -kA},
                                               {kC, -kC},
                                               {kA, -kB}}};

double fade(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

std::uint64_t lattice_key(double i) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(i));
}

}  // namespace

double gradient_noise(double x, double y, std::uint64_t seed) {
    const double x0 = std::floor(x), y0 = std::floor(y);
    const double u = x - x0, v = y - y0;
    const std::uint64_t rows[2] = {mix(seed ^ lattice_key(y0)),
                                   mix(seed ^ lattice_key(y0 + 1.0))};
    const auto corner = [&](int i, int j) {
        const Gradient& g = kGradients[mix(rows[j] ^ lattice_key(x0 + i)) >> 60];
        return g.x * (u - i) + g.y * (v - j);
    };
    const double s = fade(u), t = fade(v);
    const double north = std::lerp(corner(0, 0), corner(1, 0), s);
    const double south = std::lerp(corner(0, 1), corner(1, 1), s);
    // The extremes of 2D gradient noise with unit gradients are +-sqrt(1/2).
    return std::numbers::sqrt2 * std::lerp(north, south, t);
}

double noise_at(const NoiseOptions& options, double x, double y, std::uint64_t seed) {
    double frequency = options.grid;
    double amplitude = 1.0;
    double value = 0.0;
    double weight = 1.0;  // ridged: detail only where the coarser octaves are high
    const double falloff = std::pow(options.lacunarity, -options.h);
    for (int i = 0; i <= options.octaves; ++i) {
        double signal =
            gradient_noise(frequency * x, frequency * y,
                           hash_of({seed, key("octave"), static_cast<std::uint64_t>(i)}));
        if (options.kind == NoiseOptions::Kind::kRidged) {
            signal = options.offset - std::abs(signal);
            signal *= signal * weight;
            weight = std::clamp(signal * options.gain, 0.0, 1.0);
        }
        value += amplitude * signal;
        amplitude *= falloff;
        frequency *= options.lacunarity;
    }
    return value;
}

Field<float> noise_field(const NoiseOptions& options, int width, int height, double scale,
                         std::uint64_t seed) {
    Field<float> field(width, height);
    parallel_for(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            field(x, y) = static_cast<float>(
                scale * noise_at(options, (x + 0.5) / width, (y + 0.5) / width, seed));
        }
    });
    return field;
}

}  // namespace cydonia
