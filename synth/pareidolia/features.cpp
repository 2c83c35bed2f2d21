#include "synth/pareidolia/features.h"

#include <algorithm>

#include "field/noise.h"
#include "field/random.h"
#include "synth/distance/graph.h"
#include "synth/pareidolia/height_bound.h"
#include "synth/pareidolia/secondary.h"
#include "synth/pareidolia/shadow_plan.h"
#include "synth/pareidolia/slopes.h"

namespace cydonia::pareidolia {
namespace {

// Lit land falls at this share of the light's own slope, on average, so that it casts
// nothing.
constexpr double kLitShare = 0.44;
// A crest stands on flanks this steep where land around it is held down.
constexpr double kCrestSlope = 3.0;
// Relief of the land from the grain to sixteen times its length.
constexpr int kGrainOctaves = 5;
// Width of the anti-shadow band (step 4), of the terrain's width.
constexpr double kAntiShadowReach = 0.03;

Field<float> maximum(Field<float> a, const Field<float>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::max(a[i], b[i]);
    return a;
}

Field<float> minimum(Field<float> a, const Field<float>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::min(a[i], b[i]);
    return a;
}

// Relief inside the shadows, 0 to 1.
Field<float> inside_relief(const ShadowPlan& plan, std::uint64_t seed) {
    const NoiseOptions noise{.h = 0.8, .octaves = 4, .grid = 16.0};
    Field<float> relief = noise_field(noise, plan.width(), plan.height(), 1.0,
                                      hash_of({seed, key("inside relief")}));
    for (float& r : relief) r = std::clamp(0.5f + r, 0.0f, 1.0f);
    return relief;
}

}  // namespace

Field<float> features(const Options& options, const Terrain& base,
                      const ShadowImage& image, const Context& context) {
    const Field<float>& land = base.heights;
    const int width = land.width(), height = land.height();
    const ShadowPlan plan = shadow_plan(image, base.spacing);
    const double mean = options.features.mean_edge_weight;
    const double lit = kLitShare * plan.rise / base.spacing / mean;
    const distance::EdgeOptions edges{.mean = mean,
                                      .deviation = options.features.edge_weight_deviation,
                                      .grain = options.features.grain.in(base.width()),
                                      .octaves = kGrainOctaves};
    const std::uint64_t edge_seed = hash_of({context.seed, key("edge weights")});
    const distance::Graph graph =
        distance::graph_of(width, height, base.spacing, edges, edge_seed);
    const auto sloped = [&](const Slopes& slopes) {
        return scaled(graph, slopes, plan.frame);
    };
    const auto uniform = [&](double factor) {
        return Slopes{Field<float>(width, height, static_cast<float>(factor))};
    };

    // Complementary land first: shadows end on it.
    const std::vector<float> lowest_crests = crest_heights(plan, land);
    const float highest = *std::max_element(lowest_crests.begin(), lowest_crests.end());
    const Field<std::uint8_t> band = anti_shadow(image.target, kAntiShadowReach * width);
    const Field<float> bound =
        height_bound(land, image.target, band, image.sun.azimuth, plan.rise, highest);
    const distance::Graph layout = distance::layout_graph(graph, edges, edge_seed);
    const Field<float> secondary =
        secondary_features(options, layout, land, bound, band, context.seed);
    const Field<float> ground = maximum(land, spread(sloped(uniform(lit)), secondary));
    context.progress->report(0.4);

    const std::vector<float> crests = crest_heights(plan, ground);
    const Field<float> primary = primary_features(plan, crests);
    Field<float> heights =
        maximum(ground, spread(sloped(flank_slopes(plan, lit, 1.0)), primary,
                               constant_profiles(primary, base.spacing, mean)));
    context.progress->report(0.6);

    heights = minimum(std::move(heights),
                      ceiling(sloped(end_slopes(plan, lit)), shadow_ends(plan, ground)));
    heights =
        minimum(std::move(heights), ceiling(sloped(crest_slopes(plan, lit)), primary));
    heights =
        maximum(std::move(heights), spread(sloped(uniform(kCrestSlope / mean)), primary));
    heights = minimum(std::move(heights),
                      shadow_ceiling(plan, crests, inside_relief(plan, context.seed)));
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (primary[i] != kNowhere) heights[i] = primary[i];
    context.progress->report(1.0);
    return heights;
}

}  // namespace cydonia::pareidolia
