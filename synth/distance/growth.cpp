// B. Rusnell, "Distance-based terrain synthesis" (2009), section 3.3.1.

#include "synth/distance/growth.h"

namespace cydonia::distance {
namespace {

// Which descents the paths of these starts may follow.
std::array<bool, 256> used_by(const Shapes& shapes, std::size_t starts, int first) {
    std::array<bool, 256> used{};
    for (std::size_t i = 0; i < starts; ++i) {
        used[shapes.ways[first + i]] = true;
        if (!shapes.other_ways.empty()) used[shapes.other_ways[first + i]] = true;
    }
    for (std::uint8_t way : shapes.region_ways) used[way] = true;
    return used;
}

}  // namespace

EvenKey::EvenKey(const Shapes& shapes, std::span<const Start> starts, int first_start) {
    const std::array<bool, 256> wanted = used_by(shapes, starts.size(), first_start);
    double first = shapes.sea_level, last = 0.0;  // costs of starts
    for (const Start& start : starts) {
        first = std::min(first, 1.0 * start.cost);
        last = std::max(last, 1.0 * start.cost);
    }
    const double bin = (shapes.sea_level - first) / kBins;
    first_ = static_cast<float>(first);
    per_cost_ = static_cast<float>(1.0 / bin);

    // How far down its profile a path is at this cost, as a share; rounded outwards.
    const auto share_down = [&](double cost, double start) {
        return std::clamp((cost - start) / (shapes.sea_level - start), 0.0, 1.0);
    };
    double key = 0.0;
    for (int i = 0; i <= kBins; ++i) {
        keys_[i] = static_cast<float>(key);
        const double low = share_down(first + (i - 0.01) * bin, last);
        const double high = share_down(first + (i + 1.01) * bin, first);
        float least = kUnreached;
        for (std::size_t way = 0; way < shapes.descents.size(); ++way) {
            if (wanted[way]) {
                least = std::min(least, shapes.descents[way].least_slope(low, high));
            }
        }
        beyond_ = static_cast<float>(bin / least);
        key += bin / least;
    }
}

ProfileGrowth::ProfileGrowth(const Shapes& shapes, std::span<const Start> starts,
                             int first)
    : descents_(shapes.descents.data()),
      ways_(shapes.ways.data() + first),
      starts_(starts),
      metres_(static_cast<float>(1.0 / shapes.mean_edge_weight)),
      sea_level_(static_cast<float>(shapes.sea_level)),
      per_sea_level_(static_cast<float>(1.0 / shapes.sea_level)),
      key_(shapes, starts, first) {}

ChangingGrowth::ChangingGrowth(const Graph& graph, const Shapes& shapes,
                               std::span<const Start> starts, int first)
    : ProfileGrowth(shapes, starts, first),
      other_ways_(shapes.other_ways.empty() ? nullptr : shapes.other_ways.data() + first),
      sides_(shapes.sides.empty() ? nullptr : shapes.sides.data() + first),
      way_at_(shapes.way_at),
      graph_(&graph) {}

std::uint8_t ChangingGrowth::side_of(int origin, int direction) const {
    if (sides_ == nullptr) return 0;
    const auto [x, y] = sides_[origin];
    const Graph::Offset step = graph_->offset[direction];
    return x * static_cast<float>(step.x) + y * static_cast<float>(step.y) >= 0.0f ? 0
                                                                                   : 1;
}

}  // namespace cydonia::distance
