// B. Rusnell, "Distance-based terrain synthesis" (2009), Algorithm 3, steps 5 to 7a.

#include "synth/distance/passes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cydonia::distance {
namespace {

// Calls use(model) with the cost model of some of the starts, which begin at index
// `first`.
template <class Use>
void with_cost_model(const Ground& ground, std::span<const Start> starts, int first,
                     const Use& use) {
    const Shapes& shapes = ground.shapes;
    if (shapes.raw()) return use(RawCostModel{starts});
    if (shapes.plain()) return use(ProfileCostModel(shapes, starts, first));
    use(ChangingCostModel(shapes, starts, first));
}

// The starts of some groups as a ground of their own.
struct Part {
    Features features;
    Shapes shapes;
};

// `groups` has a bit for each group that is in the part.
Part part_of(const Ground& ground, std::uint64_t groups) {
    Part part{{}, ground.shapes};
    part.shapes.ways.clear();
    part.shapes.other_ways.clear();
    part.shapes.feature_of.clear();
    const auto keep = [](const auto& from, auto& to, int i) {
        if (!from.empty()) to.push_back(from[i]);
    };
    const Features& all = ground.features;
    for (int f = 0; f < all.count(); ++f) {
        if (!(groups >> all.features[f].group & 1)) continue;
        for (int i = all.first[f]; i < all.first[f + 1]; ++i) {
            part.features.starts.push_back(all.starts[i]);
            keep(ground.shapes.ways, part.shapes.ways, i);
            keep(ground.shapes.other_ways, part.shapes.other_ways, i);
            keep(ground.shapes.feature_of, part.shapes.feature_of, i);
        }
    }
    return part;
}

void spread_all(const Ground& ground, const Halting& halting, LeastCost& paths) {
    const std::span<const Start> starts = ground.features.starts;
    with_cost_model(ground, starts, 0, [&](const auto& model) {
        paths.spread(starts, model, [&](int, float cost) {
            return !halting.at_sea(height_of(cost, ground.shapes));
        });
    });
}

// Tells where a feature's own pass goes on.
struct Expand {
    const Ground& ground;
    const Halting& halting;
    std::span<const float> approximate;

    bool operator()(int node, float cost) const {
        return halting.goes_on(height_of(cost, ground.shapes), approximate[node]);
    }
};

Pass settled_by(const LeastCost& paths, const Ground& ground, Keep keep,
                std::size_t settled) {
    Pass pass{{paths.settled().begin(), paths.settled().end()}, {}, {}, settled};
    pass.heights.reserve(pass.nodes.size());
    for (int node : pass.nodes) {
        pass.heights.push_back(height_of(paths[node].cost, ground.shapes));
    }
    if (keep == Keep::kHeights) return pass;
    pass.labels.reserve(pass.nodes.size());
    for (int node : pass.nodes) pass.labels.push_back(paths[node]);
    return pass;
}

}  // namespace

std::vector<float> approximate_heights(const Ground& ground, const Halting& halting) {
    LeastCost paths(ground.graph);
    spread_all(ground, halting, paths);
    std::vector<float> heights(static_cast<std::size_t>(ground.graph.nodes()));
    for (int node : paths.settled()) {
        heights[node] = height_of(paths[node].cost, ground.shapes);
    }
    const Regions& regions = ground.regions;
    for (std::size_t i = 0; i < regions.open_to.size(); ++i) {
        if (regions.open_to[i] == 0) continue;
        const Part part = part_of(ground, regions.open_to[i]);
        spread_all({ground.graph, part.features, part.shapes, regions}, halting, paths);
        for (std::size_t node = 0; node < heights.size(); ++node) {
            if (regions.closed[node] == 0.0f || regions.closed_by[node] != i) continue;
            const float cost = paths[static_cast<int>(node)].cost;
            heights[node] = std::lerp(heights[node], height_of(cost, ground.shapes),
                                      regions.closed[node]);
        }
    }
    return heights;
}

Pass pass_of(int feature, const Ground& ground, const Halting& halting,
             std::span<const float> approximate, LeastCost& paths, Keep keep) {
    const std::span<const Start> starts = ground.features.of(feature);
    with_cost_model(ground, starts, ground.features.first[feature],
                    [&](const auto& model) {
                        paths.spread(starts, model, Expand{ground, halting, approximate});
                    });
    return settled_by(paths, ground, keep, paths.settled().size());
}

Pass pass_again(int feature, const Ground& ground, const Halting& halting,
                std::span<const float> approximate, const LeastCost::Trace& trace,
                LeastCost& paths) {
    const std::span<const Start> starts = ground.features.of(feature);
    std::optional<std::size_t> settled;
    with_cost_model(
        ground, starts, ground.features.first[feature], [&](const auto& model) {
            settled =
                paths.spread_again(trace, model, Expand{ground, halting, approximate});
        });
    if (settled) return settled_by(paths, ground, Keep::kLabels, *settled);
    return pass_of(feature, ground, halting, approximate, paths, Keep::kLabels);
}

}  // namespace cydonia::distance
