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
#include "synth/distance/profile.h"

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

BlendOptions blend_of(const Options& options, double sea_level, double width) {
    return {sea_level, options.blending_bias, options.sea_level_threshold.in(width),
            options.approximate_threshold, options.mean_edge_weight};
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
    const std::vector<Descent> descents = descents_of(options, sea_level, width);

    progress.step("distance: features");
    const Field<float> heights =
        blended_heights(graph, features, descents.empty() ? nullptr : &descents.front(),
                        blend_of(options, sea_level, width), progress);
    for (std::size_t i = 0; i < heights.size(); ++i) result.heights[i] += heights[i];
    return result;
}

}  // namespace cydonia::distance
