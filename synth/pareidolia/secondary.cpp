#include "synth/pareidolia/secondary.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "field/noise.h"
#include "field/random.h"
#include "synth/distance/cost_model.h"
#include "synth/pareidolia/shadow_plan.h"

namespace cydonia::pareidolia {
namespace {

// A position on the ground, in shares of its width and depth.
struct GroundPosition {
    double east, south;
};

Cell cell_at(const GroundPosition& place, int width, int height) {
    const auto cell = [](double share, int cells) {
        return std::clamp(static_cast<int>(share * cells), 0, cells - 1);
    };
    return {cell(place.east, width), cell(place.south, height)};
}

int node_at(const distance::Graph& layout, const GroundPosition& place) {
    const Cell c = cell_at(place, layout.width, layout.height);
    return layout.node(c.x, c.y);
}

GroundPosition place_of(const distance::Graph& layout, int node) {
    return {(layout.x_of(node) + 0.5) / layout.width,
            (layout.y_of(node) + 0.5) / layout.height};
}

// A random position outside the band, which is the same for every number of samples.
std::optional<GroundPosition> vacant_place(const Field<std::uint8_t>& band,
                                           std::uint64_t seed) {
    constexpr std::uint64_t kAttempts = 64;
    for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
        const GroundPosition place{unit(hash_of({seed, attempt, 0})),
                                   unit(hash_of({seed, attempt, 1}))};
        const Cell cell = cell_at(place, band.width(), band.height());
        if (!band(cell.x, cell.y)) return place;
    }
    return std::nullopt;
}

Field<float> normalised(Field<float> field) {
    const auto [low, high] = std::minmax_element(field.begin(), field.end());
    const float base = *low, range = std::max(*high - *low, 1e-6f);
    for (float& v : field) v = (v - base) / range;
    return field;
}

}  // namespace

Field<float> secondary_features(const Options& options, const distance::Graph& layout,
                                const Field<float>& base, const Field<float>& bound,
                                const Field<std::uint8_t>& band, std::uint64_t seed) {
    Field<float> heights(base.width(), base.height(), kNowhere);
    const Field<float> noise = normalised(
        noise_field(options.features.secondary_cost, base.width(), base.height(), 1.0,
                    hash_of({seed, key("secondary cost")})));
    const auto raise = [&](const GroundPosition& place) {
        const auto [x, y] = cell_at(place, base.width(), base.height());
        const float room = std::max(0.0f, bound(x, y) - base(x, y));
        heights(x, y) = base(x, y) + room * noise(x, y);
    };

    std::vector<distance::Start> peaks;
    for (int i = 0; i < options.features.secondary_peaks; ++i) {
        const auto purpose = hash_of({seed, key("peak"), static_cast<std::uint64_t>(i)});
        if (const auto place = vacant_place(band, purpose)) {
            peaks.push_back({node_at(layout, *place), 0.0f});
            raise(*place);
        }
    }
    if (peaks.empty()) return heights;

    distance::LeastCost paths(layout);
    paths.spread(peaks, distance::RawCostModel{peaks});
    // Where the land is finer than the layout, steps between its nodes close the gaps.
    const int steps = std::max(1, (base.width() + layout.width - 1) / layout.width);
    for (int i = 0; i < options.features.secondary_ridges; ++i) {
        const auto purpose = hash_of({seed, key("ridge"), static_cast<std::uint64_t>(i)});
        const auto end = vacant_place(band, purpose);
        if (!end) continue;
        GroundPosition from = place_of(layout, node_at(layout, *end));
        for (int node : path_back(layout, paths, node_at(layout, *end))) {
            const GroundPosition to = place_of(layout, node);
            for (int step = 0; step < steps; ++step) {
                const double t = (step + 1.0) / steps;
                raise({from.east + t * (to.east - from.east),
                       from.south + t * (to.south - from.south)});
            }
            from = to;
        }
    }
    return heights;
}

}  // namespace cydonia::pareidolia
