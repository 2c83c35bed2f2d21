// B. Rusnell, "Distance-based terrain synthesis" (2009), section 3.3.1.

#include "synth/distance/cost_model.h"

#include <cmath>

namespace cydonia::distance {
namespace {

// The descents that the paths of these starts may follow.
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

    // How far down its profile a path is at this cost, as a share of it, rounded
    // outwards.
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

ProfileCostModel::ProfileCostModel(const Shapes& shapes, std::span<const Start> starts,
                                   int first)
    : descents_(shapes.descents.data()),
      ways_(shapes.ways.data() + first),
      starts_(starts),
      metres_(static_cast<float>(1.0 / shapes.mean_edge_weight)),
      sea_level_(static_cast<float>(shapes.sea_level)),
      per_sea_level_(static_cast<float>(1.0 / shapes.sea_level)),
      key_(shapes, starts, first) {}

ChangingCostModel::ChangingCostModel(const Shapes& shapes, std::span<const Start> starts,
                                     int first)
    : ProfileCostModel(shapes, starts, first),
      other_ways_(shapes.other_ways.empty() ? nullptr : shapes.other_ways.data() + first),
      way_at_(shapes.way_at),
      shapes_(&shapes),
      first_(first) {}

// A node takes its side from the nearest start, so that a path that crosses a stroke
// changes sides whatever its steps.
void lay_sides(Shapes& shapes, const Graph& graph, std::span<const Start> starts,
               std::span<const std::array<float, 2>> sides) {
    constexpr int kReach = Shapes::kBeside;
    const auto nodes = static_cast<std::size_t>(graph.nodes());
    shapes.beside.assign(nodes, -1);
    shapes.side_at.assign(nodes, 0);
    std::vector<std::uint8_t> nearest(nodes, 255);  // squared cells
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const auto [east, south] = sides[i];
        if (east == 0.0f && south == 0.0f) continue;
        const int x0 = graph.x_of(starts[i].node), y0 = graph.y_of(starts[i].node);
        for (int dy = -kReach; dy <= kReach; ++dy) {
            for (int dx = -kReach; dx <= kReach; ++dx) {
                const int x = x0 + dx, y = y0 + dy, square = dx * dx + dy * dy;
                if (x < 0 || y < 0 || x >= graph.width || y >= graph.height) continue;
                const int node = graph.node(x, y);
                if (square >= nearest[node]) continue;
                const float across =
                    east * static_cast<float>(dx) + south * static_cast<float>(dy);
                nearest[node] = static_cast<std::uint8_t>(square);
                // A node on the stroke, or straight ahead of its end, is on neither side.
                shapes.beside[node] =
                    std::abs(across) < 1e-3f ? -1 : shapes.feature_of[i];
                shapes.side_at[node] = across < 0.0f ? 1 : 0;
            }
        }
    }
}

}  // namespace cydonia::distance
