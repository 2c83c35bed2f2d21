#include "synth/pareidolia/secondary.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "field/noise.h"
#include "field/random.h"
#include "synth/distance/dijkstra.h"
#include "synth/pareidolia/shadow_plan.h"

namespace cydonia::pareidolia {
namespace {

// A random cell outside the band, at the same place of the land for every number of
// samples.
std::optional<Cell> vacant_cell(const Field<std::uint8_t>& band, std::uint64_t seed) {
    constexpr std::uint64_t kAttempts = 64;
    for (std::uint64_t attempt = 0; attempt < kAttempts; ++attempt) {
        const Cell cell{
            static_cast<int>(unit(hash_of({seed, attempt, 0})) * band.width()),
            static_cast<int>(unit(hash_of({seed, attempt, 1})) * band.height())};
        if (!band(cell.x, cell.y)) return cell;
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

Field<float> secondary_features(const Options& options, const distance::Graph& graph,
                                const Field<float>& base, const Field<float>& bound,
                                const Field<std::uint8_t>& band, std::uint64_t seed) {
    Field<float> heights(base.width(), base.height(), kNowhere);
    const Field<float> noise =
        normalised(noise_field(options.secondary_cost, base.width(), base.height(), 1.0,
                               hash_of({seed, key("secondary cost")})));
    const auto place = [&](int x, int y) {
        const float room = std::max(0.0f, bound(x, y) - base(x, y));
        heights(x, y) = base(x, y) + room * noise(x, y);
    };

    std::vector<distance::Start> peaks;
    for (int i = 0; i < options.secondary_peaks; ++i) {
        const auto purpose = hash_of({seed, key("peak"), static_cast<std::uint64_t>(i)});
        if (const auto cell = vacant_cell(band, purpose)) {
            peaks.push_back({graph.node(cell->x, cell->y), 0.0f});
            place(cell->x, cell->y);
        }
    }
    if (peaks.empty()) return heights;

    distance::LeastCost paths(graph);
    paths.spread(peaks, distance::RawGrowth{peaks});
    for (int i = 0; i < options.secondary_ridges; ++i) {
        const auto purpose = hash_of({seed, key("ridge"), static_cast<std::uint64_t>(i)});
        const auto cell = vacant_cell(band, purpose);
        if (!cell) continue;
        for (int node : path_back(paths, graph.node(cell->x, cell->y)))
            place(graph.x_of(node), graph.y_of(node));
    }
    return heights;
}

}  // namespace cydonia::pareidolia
