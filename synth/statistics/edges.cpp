#include "synth/statistics/edges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/sample.h"

namespace cydonia::statistics {
namespace {

constexpr float kFaintest = 0.01f;  // slope, so that level land has no edges

std::array<float, 2> gradient(const Field<float>& land, int x, int y) {
    const int w = land.width(), h = land.height();
    const int x0 = std::max(0, x - 1), x1 = std::min(w - 1, x + 1);
    const int y0 = std::max(0, y - 1), y1 = std::min(h - 1, y + 1);
    return {(land(x1, y) - land(x0, y)) / float(std::max(1, x1 - x0)),
            (land(x, y1) - land(x, y0)) / float(std::max(1, y1 - y0))};
}

// The edge detector's response, t^(1/2) |grad L|^2.
void respond(const Scale& scale, Field<float>& power) {
    const Field<float>& land = scale.land;
    const int w = land.width(), h = land.height();
    const float weight = float(scale.deviation);
    parallel_for(h, 16, [&](int y) {
        const int y0 = std::max(0, y - 1), y1 = std::min(h - 1, y + 1);
        const float *north = land.row(y0).data(), *row = land.row(y).data(),
                    *south = land.row(y1).data();
        const float down = 1.0f / float(std::max(1, y1 - y0));
        float* out = power.row(y).data();
        for (int x = 1; x + 1 < w; ++x) {
            const float gx = 0.5f * (row[x + 1] - row[x - 1]),
                        gy = down * (south[x] - north[x]);
            out[x] = weight * (gx * gx + gy * gy);
        }
        for (const int x : {0, w - 1}) {
            const auto [gx, gy] = gradient(land, x, y);
            out[x] = weight * (gx * gx + gy * gy);
        }
    });
}

// Whether the slope is steepest there along its own direction, at that scale.
bool is_steepest(const Scale& scale, const Field<float>& power, int x, int y) {
    const auto [gx, gy] = gradient(scale.land, x, y);
    const float length = std::sqrt(gx * gx + gy * gy);
    if (!(length > 0.0f)) return false;
    const float own = power(x, y);
    const double dx = gx / length, dy = gy / length;
    return own > float(bilinear(power, x + dx, y + dy)) &&
           own >= float(bilinear(power, x - dx, y - dy));
}

}  // namespace

std::vector<Feature> edges_of(const std::vector<Scale>& land, double spacing) {
    if (land.empty()) return {};
    const int w = land[0].land.width(), h = land[0].land.height();
    Found found(w, h);
    std::array<Field<float>, 3> powers;  // responses of a scale and of its two neighbours
    powers.fill(Field<float>(w, h));
    for (int k = 0; k < int(land.size()); ++k) {
        respond(land[std::size_t(k)], powers[std::size_t(k % 3)]);
        if (k < 2) continue;
        const Scale& scale = land[std::size_t(k - 1)];
        const Field<float>& own = powers[std::size_t((k - 1) % 3)];
        find_largest(
            powers[std::size_t((k - 2) % 3)], own, powers[std::size_t(k % 3)], 1.0f,
            k - 1, kFaintest * kFaintest * float(scale.deviation),
            [&](int x, int y) { return is_steepest(scale, own, x, y); }, found);
    }
    for (std::size_t i = 0; i < found.place.size(); ++i)
        if (found.place[i] >= 0.0f) found.response[i] = std::sqrt(found.response[i]);
    return linked(found, spacing);
}

std::vector<Feature> edges_of(const Field<float>& heights, double spacing) {
    Field<float> slopes = heights;
    for (float& height : slopes) height = float(height / spacing);
    return edges_of(scale_space(slopes), spacing);
}

}  // namespace cydonia::statistics
