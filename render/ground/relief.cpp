#include "render/ground/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "field/parallel.h"

namespace cydonia::render {
namespace {

constexpr double kBeach = 50.0;

// Box means of (2 * radius + 1)^2 samples, clamped at the edges.
Field<float> blurred(const Field<float>& field, int radius) {
    if (radius < 1) return field;
    const auto pass =
        [radius](const Field<float>& in) {  // along rows; the result is transposed
            Field<float> out(in.height(), in.width());
            parallel_for(in.height(), 16, [&](int y) {
                const auto row = in.row(y);
                const auto at = [&](int x) {
                    return double(row[std::size_t(std::clamp(x, 0, in.width() - 1))]);
                };
                double sum = 0.0;
                for (int i = -radius; i <= radius; ++i) sum += at(i);
                for (int x = 0; x < in.width(); ++x) {
                    out(y, x) = static_cast<float>(sum / (2 * radius + 1));
                    sum += at(x + radius + 1) - at(x - radius);
                }
            });
            return out;
        };
    return pass(pass(field));
}

struct Rise {
    double east, north;  // per metre
    double steepness() const { return std::hypot(east, north); }
};

Rise rise_at(const Field<float>& h, double spacing, int x, int y) {
    const int w = std::max(x - 1, 0), e = std::min(x + 1, h.width() - 1);
    const int n = std::max(y - 1, 0), s = std::min(y + 1, h.height() - 1);
    return {(h(e, y) - h(w, y)) / (spacing * std::max(1, e - w)),
            (h(x, n) - h(x, s)) / (spacing * std::max(1, s - n))};
}

// The drained area per metre of contour at each sample, metres. From the highest sample
// down each passes its area on to all lower neighbours, more to steeper ones.
Field<float> drained(const Field<float>& h, double spacing) {
    std::vector<std::uint32_t> order(h.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return h[a] != h[b] ? h[a] > h[b] : a < b;
    });
    Field<float> area(h.width(), h.height(), static_cast<float>(spacing));
    for (const std::uint32_t i : order) {
        const int x = static_cast<int>(i % h.width()),
                  y = static_cast<int>(i / h.width());
        std::array<double, 9> share{};
        double sum = 0.0;
        for (int k = 0; k < 9; ++k) {
            const int dx = k % 3 - 1, dy = k / 3 - 1;
            if (!h.contains(x + dx, y + dy)) continue;
            const double drop = h[i] - h(x + dx, y + dy);
            if (drop <= 0.0) continue;
            share[k] = std::pow(drop / (dx && dy ? std::sqrt(2.0) : 1.0), 1.1);
            sum += share[k];
        }
        for (int k = 0; k < 9; ++k)
            if (share[k] > 0.0)
                area(x + k % 3 - 1, y + k / 3 - 1) +=
                    static_cast<float>(area[i] * share[k] / sum);
    }
    return area;
}

void set_wetness(Relief& r, const Field<float>& heights, double spacing, int radius) {
    const Field<float> calm = blurred(heights, radius);
    const Field<float> area = drained(calm, spacing);
    Field<float> wet(calm.width(), calm.height());
    parallel_for(calm.height(), 16, [&](int y) {
        for (int x = 0; x < calm.width(); ++x)
            wet(x, y) = static_cast<float>(std::log(
                area(x, y) / std::max(0.01, rise_at(calm, spacing, x, y).steepness())));
    });
    wet = blurred(wet, 1);
    for (std::size_t i = 0; i < wet.size(); ++i) r.forms[i].wet = wet[i];
}

void set_shore(Relief& r, const Terrain& terrain, int radius) {
    const Field<float> depths = water_depths(terrain);
    r.water = std::ranges::max(depths) > 0.0f;
    if (!r.water) return;
    Field<float> wet(depths.width(), depths.height()), level = wet;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        wet[i] = depths[i] > 0.0f ? 1.0f : 0.0f;
        level[i] = depths[i] > 0.0f ? terrain.water[i] : 0.0f;
    }
    wet = blurred(wet, radius);
    level = blurred(level, radius);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        Form& form = r.forms[i];
        form.level = wet[i] > 0.0f ? level[i] / wet[i] : 0.0f;
        form.shore = std::min(1.0f, 4.0f * wet[i]);
        if (depths[i] > 0.0f) form.level = terrain.water[i], form.shore = 1.0f;
    }
}

void set_range(Relief& r, const Terrain& terrain) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = 0; i < r.forms.size(); ++i) {
        if (water_depth(terrain, i) > 0.0f) continue;
        low = std::min<double>(low, r.forms[i].height);
        high = std::max<double>(high, r.forms[i].height);
    }
    if (low <= high) r.lowest = low, r.range = high - low;
}

}  // namespace

Relief relief_of(const Terrain& terrain, bool wetness) {
    const Field<float>& h = terrain.heights;
    const double spacing = terrain.spacing;
    const auto cells = [&](double metres) {
        return static_cast<int>(std::lround(metres / spacing / 2.0));
    };
    const Field<float> near = blurred(h, cells(15.0) / 2);
    const Field<float> far = blurred(h, std::max(1, cells(45.0)));
    const int edge = std::max(1, cells(30.0));
    const Field<float> beside = blurred(h, edge);
    // A change of slope by this much over the width is a sharp edge.
    const double sharp = 0.12 * (edge + 0.5) * spacing;
    const Field<float> around = blurred(h, std::max(1, cells(120.0)));
    Relief r;
    r.forms = Field<Form>(h.width(), h.height());
    parallel_for(h.height(), 16, [&](int y) {
        for (int x = 0; x < h.width(); ++x) {
            const Rise rise = rise_at(near, spacing, x, y);
            const double steep = rise.steepness();
            const double mixed =
                0.35 * steep + 0.65 * rise_at(far, spacing, x, y).steepness();
            Form& form = r.forms(x, y);
            form.height = h(x, y);
            form.slope = static_cast<float>(std::atan(mixed));
            form.north = static_cast<float>(-rise.north / std::hypot(1.0, steep));
            form.cavity = static_cast<float>(
                std::clamp((beside(x, y) - h(x, y)) / sharp, -1.0, 1.0));
            form.hollow = around(x, y) - h(x, y);
        }
    });
    if (wetness) set_wetness(r, h, spacing, cells(60.0));
    set_shore(r, terrain, std::max(1, cells(2.0 * kBeach)));
    set_range(r, terrain);
    return r;
}

}  // namespace cydonia::render
