#include "render/fine_relief/craters.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"
#include "field/random.h"
#include "field/smoothstep.h"

namespace cydonia::render {
namespace {

constexpr double kCraterCell =
    2.5;  // side of a lattice cell, in diameters; each may hold a crater
constexpr double kShare = 0.55;  // of the cells that hold one
constexpr double kThrown = 2.2;  // reach of the ejecta, in radii

// The height of a fresh crater of diameter 1 at r radii from its middle.
double profile(double r) {
    constexpr double kDepth = 0.2, kRim = 0.036;
    if (r >= kThrown) return 0.0;
    const double bowl = -kDepth + (kDepth + kRim) * r * r;
    const double left = (kThrown - r) / (kThrown - 1.0);
    const double thrown = kRim * left * left / std::max(1.0, r * r);
    if (r <= 0.9) return bowl;
    if (r >= 1.1) return thrown;
    return std::lerp(bowl, thrown, smoothstep(0.9, 1.1, r));  // a rounded rim
}

struct Crater {
    float x, y;           // metres
    float radius = 0.0f;  // 0: none
    float height = 0.0f;  // scale of the profile, metres
};

// The crater of a lattice cell, if it holds one.
Crater crater_of(int i, int j, double cell, double diameter, std::uint64_t seed) {
    const std::uint64_t h = hash_of({seed, key("crater"), static_cast<std::uint64_t>(i),
                                     static_cast<std::uint64_t>(j)});
    if (unit(h) >= kShare) return {};
    const double size = diameter * (0.5 + 0.5 * unit(mix(h ^ 1)));
    const double fresh = std::pow(unit(mix(h ^ 2)), 2.5);  // most are old, nearly filled
    return {static_cast<float>((i + unit(mix(h ^ 3))) * cell),
            static_cast<float>((j + unit(mix(h ^ 4))) * cell),
            static_cast<float>(0.5 * size), static_cast<float>(size * fresh)};
}

}  // namespace

Field<float> craters(int width, int height, double spacing, double diameter,
                     std::uint64_t seed) {
    const double cell = kCraterCell * diameter;
    const int across = static_cast<int>(width * spacing / cell) + 1;
    const int down = static_cast<int>(height * spacing / cell) + 1;
    Field<Crater> lattice(across + 2, down + 2);  // with a margin of one cell
    for (int j = 0; j < down + 2; ++j)
        for (int i = 0; i < across + 2; ++i)
            lattice(i, j) = crater_of(i - 1, j - 1, cell, diameter, seed);
    Field<float> result(width, height);
    parallel_for(height, 8, [&](int y) {
        const auto py = static_cast<float>((y + 0.5) * spacing);
        const int j = static_cast<int>(py / cell);
        for (int x = 0; x < width; ++x) {
            const auto px = static_cast<float>((x + 0.5) * spacing);
            const int i = static_cast<int>(px / cell);
            float sum = 0.0f;
            for (int b = j; b <= j + 2; ++b)
                for (int a = i; a <= i + 2; ++a) {
                    const Crater& c = lattice(a, b);
                    const float dx = px - c.x, dy = py - c.y;
                    const float reach = static_cast<float>(kThrown) * c.radius;
                    const float square = dx * dx + dy * dy;
                    if (square < reach * reach)
                        sum += c.height *
                               static_cast<float>(profile(std::sqrt(square) / c.radius));
                }
            result(x, y) = sum;
        }
    });
    return result;
}

}  // namespace cydonia::render
