#include "synth/genetic/edges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/parallel.h"
#include "field/sample.h"

namespace cydonia::genetic {
namespace {

constexpr double kFinest = 1.0, kCoarsest = 16.0, kStep = 1.4142135623730951;
constexpr int kShortest = 5;        // samples: shorter ones are noise
constexpr float kFaintest = 0.01f;  // of slope: level land has none

int mirrored(int i, int n) {
    if (n == 1) return 0;
    const int period = 2 * n - 2;
    i = ((i % period) + period) % period;
    return i < n ? i : period - i;
}

std::vector<float> gaussian(double deviation) {
    const int radius = int(std::ceil(4.0 * deviation));
    std::vector<float> weights(std::size_t(2 * radius + 1));
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i)
        sum += std::exp(-0.5 * i * i / (deviation * deviation));
    for (int i = -radius; i <= radius; ++i)
        weights[std::size_t(i + radius)] =
            float(std::exp(-0.5 * i * i / (deviation * deviation)) / sum);
    return weights;
}

struct Scale {
    double deviation;    // samples
    Field<float> land;   // L
    Field<float> power;  // t^(1/2) |grad L|^2
};

std::array<float, 2> gradient(const Field<float>& land, int x, int y) {
    const int w = land.width(), h = land.height();
    const int x0 = std::max(0, x - 1), x1 = std::min(w - 1, x + 1);
    const int y0 = std::max(0, y - 1), y1 = std::min(h - 1, y + 1);
    return {(land(x1, y) - land(x0, y)) / float(std::max(1, x1 - x0)),
            (land(x, y1) - land(x, y0)) / float(std::max(1, y1 - y0))};
}

std::vector<Scale> scale_space(const Field<float>& heights) {
    std::vector<Scale> scales;
    const double coarsest =
        std::min(kCoarsest, std::min(heights.width(), heights.height()) / 8.0);
    for (double deviation = kFinest; deviation <= coarsest * 1.01; deviation *= kStep) {
        Scale scale{deviation, blurred(heights, deviation),
                    Field<float>(heights.width(), heights.height())};
        const float weight = float(deviation);  // t^(1/2)
        parallel_for(heights.height(), 16, [&](int y) {
            for (int x = 0; x < heights.width(); ++x) {
                const auto [gx, gy] = gradient(scale.land, x, y);
                scale.power(x, y) = weight * (gx * gx + gy * gy);
            }
        });
        scales.push_back(std::move(scale));
    }
    return scales;
}

// Where the power is largest over scales; between two by a parabola through three. None:
// -1.
float best_scale(const std::vector<Scale>& scales, std::size_t i) {
    float best = -1.0f, most = 0.0f;
    for (std::size_t k = 1; k + 1 < scales.size(); ++k) {
        const float a = scales[k - 1].power[i], b = scales[k].power[i],
                    c = scales[k + 1].power[i];
        if (!(b > a && b >= c && b > most)) continue;
        const float bend = a - 2.0f * b + c;
        most = b;
        best = float(k) + (bend < 0.0f ? 0.5f * (a - c) / bend : 0.0f);
    }
    return best;
}

// Whether the slope is steepest there along itself, at that scale.
bool is_steepest(const Scale& scale, int x, int y) {
    const auto [gx, gy] = gradient(scale.land, x, y);
    const float length = std::hypot(gx, gy);
    if (!(length > 0.0f)) return false;
    const float own = scale.power(x, y);
    const double dx = gx / length, dy = gy / length;
    return own > float(bilinear(scale.power, x + dx, y + dy)) &&
           own >= float(bilinear(scale.power, x - dx, y - dy));
}

}  // namespace

Field<float> blurred(const Field<float>& field, double deviation) {
    const std::vector<float> weights = gaussian(deviation);
    const int radius = int(weights.size()) / 2, w = field.width(), h = field.height();
    Field<float> rows(w, h), result(w, h);
    parallel_for(h, 8, [&](int y) {
        std::vector<float> line(std::size_t(w + 2 * radius));
        for (int x = -radius; x < w + radius; ++x)
            line[std::size_t(x + radius)] = field(mirrored(x, w), y);
        for (int x = 0; x < w; ++x) rows(x, y) = 0.0f;
        for (std::size_t k = 0; k < weights.size(); ++k)
            for (int x = 0; x < w; ++x)
                rows(x, y) += weights[k] * line[std::size_t(x) + k];
    });
    parallel_for(h, 8, [&](int y) {
        for (int x = 0; x < w; ++x) result(x, y) = 0.0f;
        for (int k = -radius; k <= radius; ++k) {
            const float weight = weights[std::size_t(k + radius)];
            const int from = mirrored(y + k, h);
            for (int x = 0; x < w; ++x) result(x, y) += weight * rows(x, from);
        }
    });
    return result;
}

std::vector<Edge> edges_of(const Field<float>& heights, double spacing) {
    const int w = heights.width(), h = heights.height();
    Field<float> slopes = heights;
    for (float& height : slopes) height = float(height / spacing);
    const std::vector<Scale> scales = scale_space(slopes);
    // Of samples on an edge the scale, of others -1.
    Field<float> found(w, h, -1.0f);
    parallel_for(h, 8, [&](int y) {
        for (int x = 0; x < w; ++x) {
            const float k = best_scale(scales, found.index(x, y));
            if (k < 0.0f) continue;
            const Scale& scale = scales[std::size_t(std::lround(k))];
            const float faintest = kFaintest * kFaintest * float(scale.deviation);
            if (scale.power(x, y) > faintest && is_steepest(scale, x, y)) found(x, y) = k;
        }
    });

    std::vector<Edge> edges;
    std::vector<std::array<int, 2>> open;
    Field<std::uint8_t> seen(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (found(x, y) < 0.0f || seen(x, y)) continue;
            // All that hangs together, in the plane and from scale to scale.
            double scale = 0.0, strength = 0.0;
            int count = 0;
            open.assign(1, {x, y});
            seen(x, y) = 1;
            while (!open.empty()) {
                const auto [i, j] = open.back();
                open.pop_back();
                const float k = found(i, j);
                ++count;
                scale += kFinest * std::pow(kStep, double(k));
                strength += std::sqrt(scales[std::size_t(std::lround(k))].power(i, j));
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int p = i + dx, q = j + dy;
                        if (p < 0 || q < 0 || p >= w || q >= h || seen(p, q)) continue;
                        if (found(p, q) < 0.0f || std::abs(found(p, q) - k) > 1.5f)
                            continue;
                        seen(p, q) = 1;
                        open.push_back({p, q});
                    }
            }
            if (count >= kShortest)
                edges.push_back({float(scale / count * spacing), float(count * spacing),
                                 float(strength / count)});
        }
    return edges;
}

}  // namespace cydonia::genetic
