// B. Rusnell, "Distance-based terrain synthesis" (2009), Algorithm 3, steps 1 to 4.

#include "synth/distance/layout.h"

#include <algorithm>

namespace cydonia::distance {
namespace {

// Step 3, eq. 3.1.
double sea_level_of(const Features& features, double scale) {
    double highest = 0.0;
    for (const Start& start : features.starts) {
        highest = std::max(highest, 1.0 * start.cost);
    }
    return scale * highest;
}

// Generators at or above the cost of sea level raise no land and are left out
// (docs/papers.md, Rusnell 7).
Features above_sea(const Features& features, double sea_level) {
    Features kept;
    for (int f = 0; f < features.count(); ++f) {
        const std::size_t before = kept.starts.size();
        for (int i = features.first[f]; i < features.first[f + 1]; ++i) {
            if (!(features.starts[i].cost < sea_level)) continue;
            kept.starts.push_back(features.starts[i]);
            if (!features.sides.empty()) kept.sides.push_back(features.sides[i]);
        }
        if (kept.starts.size() == before) continue;
        kept.first.push_back(static_cast<int>(kept.starts.size()));
        kept.features.push_back(features.features[f]);
    }
    return kept;
}

// Raw edge weights as a profile, for features without a profile when others have one.
Descent straight_descent(const Options& options, double sea_level, double width) {
    Profile straight;
    straight.curve.points = {{0.0, 1.0}, {1.0, 0.0}};
    straight.reach = metres(sea_level / options.mean_edge_weight);
    return descent_of(straight, sea_level, options.mean_edge_weight,
                      options.minimum_scale, width);
}

// Step 4, and the profile of each start and each region.
Shapes shapes_of(const Options& options, const Graph& graph, const Features& features,
                 const Regions& regions, double sea_level, double width) {
    Shapes shapes{.sea_level = sea_level, .mean_edge_weight = options.mean_edge_weight};
    const bool shaped = !regions.profile_at.empty() ||
                        std::ranges::any_of(features.features,
                                            [](const auto& f) { return f.profile >= 0; });
    if (!shaped) return shapes;

    shapes.descents = descents_of(options, sea_level, width);
    const auto raw = static_cast<std::uint8_t>(shapes.descents.size());
    shapes.descents.push_back(straight_descent(options, sea_level, width));
    const auto way = [&](int profile) {
        return profile < 0 ? raw : static_cast<std::uint8_t>(profile);
    };
    const bool sides = std::ranges::any_of(
        features.features, [](const auto& f) { return f.other_side >= 0; });
    for (int f = 0; f < features.count(); ++f) {
        const Features::Feature& feature = features.features[f];
        const std::size_t starts = features.of(f).size();
        const int other = feature.other_side < 0 ? feature.profile : feature.other_side;
        shapes.ways.insert(shapes.ways.end(), starts, way(feature.profile));
        if (!sides) continue;
        shapes.other_ways.insert(shapes.other_ways.end(), starts, way(other));
        shapes.feature_of.insert(shapes.feature_of.end(), starts, f);
    }
    if (sides) lay_sides(shapes, graph, features.starts, features.sides);
    shapes.way_at = regions.profile_at;
    for (const RegionOptions& region : options.regions) {
        const auto at =
            std::ranges::find(options.profiles, region.profile, &Profile::name);
        if (at == options.profiles.end()) continue;
        shapes.region_ways.push_back(
            static_cast<std::uint8_t>(at - options.profiles.begin()));
    }
    return shapes;
}

Halting halting_of(const Options& options, double width) {
    return {static_cast<float>(options.sea_level_threshold.in(width)),
            static_cast<float>(options.approximate_threshold)};
}

}  // namespace

Layout layout_of(const Options& options, const Terrain& terrain, std::uint64_t seed) {
    const double width = terrain.width();
    Layout layout;
    layout.graph = graph_of(terrain.heights.width(), terrain.heights.height(),
                            terrain.spacing, edges_of(options, width), seed);
    const Features placed = features_of(options, layout.graph, terrain, seed);
    const double sea_level = sea_level_of(placed, options.sea_level_scale);
    layout.features = above_sea(placed, sea_level);
    layout.regions = regions_of(options, layout.graph, placed);
    layout.shapes = shapes_of(options, layout.graph, layout.features, layout.regions,
                              sea_level, width);
    layout.halting = halting_of(options, width);
    return layout;
}

}  // namespace cydonia::distance
