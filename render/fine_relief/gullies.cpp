#include "render/fine_relief/gullies.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "field/random.h"
#include "field/smoothstep.h"
#include "render/ground/texture_noise.h"

namespace cydonia::render {
namespace {

constexpr float kStripeCell = 1.3f;  // side of a lattice cell, in wavelengths
constexpr float kReach = 1.5f;       // reach of the stripes of an origin, in cells
constexpr float kLeastSlope = 0.14f,
                kMostSlope = 0.75f;  // slopes at which gullies begin and are full
constexpr float kWall = 1.1f,
                kSheer =
                    3.0f;  // slopes over which they fade to 0.4, since water falls there

// Cosine and sine of a phase in turns, accurate to 2e-4.
struct Wave {
    float c, s;
};
float sine_of_turns(float x) {
    x -= std::floor(x + 0.5f);  // -0.5 to 0.5
    const float y = x * (8.0f - 16.0f * std::fabs(x));
    return y * (0.776f + 0.224f * std::fabs(y));
}
Wave wave(float turns) { return {sine_of_turns(turns + 0.25f), sine_of_turns(turns)}; }

struct Origin {
    float x, y;
};

// One origin for every lattice cell, with a margin of one cell.
Field<Origin> origins(int across, int down, std::uint64_t seed) {
    Field<Origin> result(across + 2, down + 2);
    for (int j = 0; j < result.height(); ++j)
        for (int i = 0; i < result.width(); ++i) {
            const std::uint64_t h =
                hash_of({seed, key("gully"), static_cast<std::uint64_t>(i),
                         static_cast<std::uint64_t>(j)});
            result(i, j) = {static_cast<float>(i - 1 + unit(h)),
                            static_cast<float>(j - 1 + unit(mix(h)))};
        }
    return result;
}

// The blended stripes of all origins near the point (px, py) of the lattice; their phase
// rises along (ax, ay), in turns a cell.
Wave blended(const Field<Origin>& from, float px, float py, float ax, float ay) {
    const int i = static_cast<int>(px), j = static_cast<int>(py);
    Wave sum{0.0f, 0.0f};
    for (int dj = 0; dj < 3; ++dj)
        for (int di = 0; di < 3; ++di) {
            const Origin& o = from(i + di, j + dj);
            const float vx = px - o.x, vy = py - o.y;
            const float near = 1.0f - (vx * vx + vy * vy) * (1.0f / (kReach * kReach));
            if (near <= 0.0f) continue;
            const Wave w = wave(vx * ax + vy * ay);
            sum.c += near * near * w.c;
            sum.s += near * near * w.s;
        }
    return sum;
}

}  // namespace

Field<float> gullies(const Field<float>& heights, double spacing, double wavelength,
                     std::uint64_t seed) {
    const int width = heights.width(), height = heights.height();
    const auto lattice = static_cast<float>(spacing / (kStripeCell * wavelength));
    const Field<Origin> from =
        origins(static_cast<int>(lattice * static_cast<float>(width)) + 1,
                static_cast<int>(lattice * static_cast<float>(height)) + 1, seed);
    // Slopes are measured over half a wavelength, since finer form does not turn the
    // water.
    const int step =
        std::max(1, static_cast<int>(std::lround(0.25 * wavelength / spacing)));
    const auto per_metre = static_cast<float>(0.5 / (step * spacing));
    Field<float> result(width, height);
    parallel_for(height, 8, [&](int y) {
        const int north = std::max(y - step, 0), south = std::min(y + step, height - 1);
        for (int x = 0; x < width; ++x) {
            const float east_rise = (heights(std::min(x + step, width - 1), y) -
                                     heights(std::max(x - step, 0), y)) *
                                    per_metre;
            const float south_rise = (heights(x, south) - heights(x, north)) * per_metre;
            const float slope =
                std::sqrt(east_rise * east_rise + south_rise * south_rise);
            if (slope <= kLeastSlope) continue;
            // Across the slope, in turns a lattice cell.
            const float ax = -south_rise / slope * kStripeCell,
                        ay = east_rise / slope * kStripeCell;
            const float px = (static_cast<float>(x) + 0.5f) * lattice;
            const float py = (static_cast<float>(y) + 0.5f) * lattice;
            const Wave blend = blended(from, px, py, ax, ay);
            const float length = std::sqrt(blend.c * blend.c + blend.s * blend.s);
            if (length <= 0.0f) continue;
            const float u = blend.c / length;
            // Makes ribs sharper than gullies.
            const float sharp = 1.0f - 2.0f * std::sqrt(std::max(0.0f, 0.5f - 0.5f * u));
            // Makes gullies deep in some places and faint in others.
            const auto deep = static_cast<float>(std::clamp(
                0.6 + 0.9 * texture_noise((x + 0.5) * spacing, (y + 0.5) * spacing,
                                          7.0 * wavelength, seed),
                0.1, 1.4));
            const float wall = std::clamp((slope - kWall) / (kSheer - kWall), 0.0f, 1.0f);
            result(x, y) = (1.0f - 0.6f * wall) * deep *
                           smoothstep(kLeastSlope, kMostSlope, slope) *
                           std::min(1.0f, 2.0f * length) * (0.5f * u + 0.5f * sharp);
        }
    });
    return result;
}

}  // namespace cydonia::render
