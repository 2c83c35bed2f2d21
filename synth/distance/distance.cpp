// B. Rusnell, "Distance-based terrain synthesis" (2009), Algorithm 3.

#include "synth/distance/distance.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "field/error.h"
#include "synth/distance/blend.h"
#include "synth/distance/features.h"
#include "synth/distance/graph.h"
#include "synth/distance/map.h"
#include "synth/distance/profile.h"
#include "synth/distance/water.h"

namespace cydonia::distance {
namespace {

void require(bool holds, const char* name, double value, const char* rule) {
    if (!holds) throw bad_request("{} is {}: it must be {}", name, value, rule);
}

void check(const Options& options, const Terrain& terrain) {
    const double width = terrain.width();
    require(options.sea_level_scale > 0.0, "sea_level_scale", options.sea_level_scale,
            "above 0");
    require(options.blending_bias >= 0.0, "blending_bias", options.blending_bias,
            "at least 0");
    require(options.sea_level_threshold.in(width) >= 0.0, "sea_level_threshold (m)",
            options.sea_level_threshold.in(width), "at least 0");
    require(options.approximate_threshold >= 0.0 && options.approximate_threshold < 1.0,
            "approximate_threshold", options.approximate_threshold,
            "at least 0 and below 1");
    require(options.minimum_scale > 0.0, "minimum_scale", options.minimum_scale,
            "above 0");
}

void check_memory(const Options& options, double cells) {
    const double graph = cells * options.neighbours / 2 * sizeof(float);
    const double needed = graph + blend_bytes(cells);
    const double present = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                           static_cast<double>(sysconf(_SC_PAGE_SIZE));
    if (needed > present) {
        throw bad_request(
            "the distance stage would take {:.1f} GiB and this machine has {:.1f}: lower "
            "samples",
            needed / 0x1p30, present / 0x1p30);
    }
}

// Step 3, eq. 3.1.
double sea_level_of(const Features& features, double scale) {
    double highest = 0.0;
    for (const Start& start : features.starts) {
        highest = std::max(highest, 1.0 * start.cost);
    }
    return scale * highest;
}

// Generators at or above the cost of sea level emit nothing (notes.md, Rusnell 7).
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

// Raw edge weights as a profile, for features without one among others.
Descent straight_descent(const Options& options, double sea_level, double width) {
    Profile straight;
    straight.curve.points = {{0.0, 1.0}, {1.0, 0.0}};
    straight.reach = metres(sea_level / options.mean_edge_weight);
    return descent_of(straight, sea_level, options.mean_edge_weight,
                      options.minimum_scale, width);
}

// Step 4, and which profile each start and each region has.
Shapes shapes_of(const Options& options, const Features& features, const Regions& regions,
                 double sea_level, double width) {
    Shapes shapes{sea_level, options.mean_edge_weight, {}, {}, {}, {}, {}, {}};
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
        if (sides) shapes.other_ways.insert(shapes.other_ways.end(), starts, way(other));
    }
    if (sides) shapes.sides = features.sides;
    shapes.way_at = regions.profile_at;
    for (const Region& region : options.regions) {
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

BlendOptions blend_of(const Options& options, const Graph& graph) {
    BlendOptions blend{options.blending_bias, {}};
    if (options.blending_bias_map) {
        blend.bias_map =
            map_values(*options.blending_bias_map, graph.width, graph.height);
    }
    return blend;
}

// Step 7, with what is remembered from the last run.
Field<float> blended(const Options& options, const Ground& ground, const Halting& halting,
                     const std::vector<float>& approximate, const Context& context) {
    std::optional<PassMemory> memory;
    if (context.memory) memory.emplace(ground, halting, context.memory->recall());
    PassCounts counts;
    Field<float> heights = blended_heights(
        ground, halting, blend_of(options, ground.graph), approximate, *context.progress,
        {memory ? &*memory : nullptr, nullptr}, &counts);
    if (memory && counts.recalled < counts.features) {
        context.memory->keep(memory->bytes());
    }
    return heights;
}

void lay_over(Field<float>& land, const Field<float>& heights, const Options& options) {
    const auto scale = static_cast<float>(options.vertical_scale);
    for (std::size_t i = 0; i < land.size(); ++i) {
        const float before = options.combine == Options::Combine::kAdd ? land[i] : 0.0f;
        land[i] = before + scale * heights[i];
    }
}

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    check(options, terrain);
    check_memory(options, static_cast<double>(terrain.heights.size()));
    Progress& progress = *context.progress;
    const double width = terrain.width();

    progress.step("distance: graph and generators");
    const Graph graph = graph_of(terrain.heights.width(), terrain.heights.height(),
                                 terrain.spacing, edges_of(options, width), context.seed);
    const Features placed = features_of(options, graph, terrain, context.seed);
    const double sea_level = sea_level_of(placed, options.sea_level_scale);
    const Features features = above_sea(placed, sea_level);
    Terrain result = terrain;
    if (features.count() == 0) {
        progress.warn("distance: every generator lies at sea level, so no land rises");
        return result;
    }
    const Regions regions = regions_of(options, graph, features);
    const Shapes shapes = shapes_of(options, features, regions, sea_level, width);
    const Ground ground{graph, features, shapes, regions};
    const Halting halting = halting_of(options, width);

    progress.step("distance: features");
    const std::vector<float> approximate = approximate_heights(ground, halting);
    lay_over(result.heights,
             options.preview ? by_sample(graph, approximate)
                             : blended(options, ground, halting, approximate, context),
             options);
    lay_water(result, options, graph);
    return result;
}

}  // namespace cydonia::distance
