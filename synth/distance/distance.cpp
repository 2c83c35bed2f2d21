// B. Rusnell, "Distance-based terrain synthesis" (2009), Algorithm 3.

#include "synth/distance/distance.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>

#include "field/error.h"
#include "field/files.h"
#include "synth/distance/blend.h"
#include "synth/distance/explain.h"
#include "synth/distance/layout.h"
#include "synth/distance/map.h"
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

BlendOptions blend_of(const Options& options, const Graph& graph) {
    BlendOptions blend{options.blending_bias, {}};
    if (options.blending_bias_map) {
        blend.bias_map =
            map_values(*options.blending_bias_map, graph.width, graph.height);
    }
    return blend;
}

std::string remembered(const Memory& memory) {
    constexpr std::size_t kMostBytes = std::size_t{512} << 20;
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(memory.last, none);
    return none || size > kMostBytes ? "" : read_text(memory.last, kMostBytes);
}

// Step 7, with the passes that are remembered from the last run.
Field<float> blended(const Options& options, const Ground& ground, const Halting& halting,
                     const std::vector<float>& approximate, Explainer* explainer,
                     const Context& context) {
    std::optional<PassMemory> memory;
    if (context.memory) memory.emplace(ground, halting, remembered(*context.memory));
    PassCounts counts;
    Field<float> heights = blended_heights(
        ground, halting, blend_of(options, ground.graph), approximate, *context.progress,
        {memory ? &*memory : nullptr, explainer}, &counts);
    if (explainer) explainer->finish();
    if (memory && counts.recalled < counts.features) {
        write_text(context.memory->next, memory->taken_bytes());
    }
    return heights;
}

// Steps 5 to 7.
Field<float> heights_of(const Options& options, const Layout& layout,
                        const Context& context) {
    if (layout.features.count() == 0) {
        context.progress->warn(
            "distance: every generator lies at sea level, so no land rises");
        return Field<float>(layout.graph.width, layout.graph.height);
    }
    context.progress->step("distance: features");
    const Ground ground = layout.ground();
    const std::vector<float> approximate = approximate_heights(ground, layout.halting);
    std::optional<Explainer> explainer;
    if (context.explain) {
        explainer.emplace(*context.explain, options, ground, layout.halting, approximate);
    }
    if (options.preview) return by_sample(layout.graph, approximate);
    return blended(options, ground, layout.halting, approximate,
                   explainer ? &*explainer : nullptr, context);
}

// When the terrain so far is replaced, its water is removed too.
void lay_over(Terrain& terrain, const Field<float>& heights, const Options& options) {
    const auto scale = static_cast<float>(options.vertical_scale);
    const bool adds = options.combine == Options::Combine::kAdd;
    if (!adds) terrain.water = {};
    Field<float>& land = terrain.heights;
    for (std::size_t i = 0; i < land.size(); ++i) {
        const float before = adds ? land[i] : 0.0f;
        land[i] = before + scale * heights[i];
    }
}

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    check(options, terrain);
    check_memory(options, static_cast<double>(terrain.heights.size()));

    context.progress->step("distance: graph and generators");
    const Layout layout = layout_of(options, terrain, context.seed);
    Terrain result = terrain;
    lay_over(result, heights_of(options, layout, context), options);
    lay_water(result, options, layout.graph);
    return result;
}

}  // namespace cydonia::distance
