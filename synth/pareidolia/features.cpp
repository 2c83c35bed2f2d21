#include "synth/pareidolia/features.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>

#include "field/noise.h"
#include "field/random.h"
#include "synth/distance/graph.h"
#include "synth/pareidolia/height_bound.h"
#include "synth/pareidolia/holes.h"
#include "synth/pareidolia/region_tree.h"
#include "synth/pareidolia/secondary.h"
#include "synth/pareidolia/shadow_lines.h"
#include "synth/pareidolia/shadow_plan.h"
#include "synth/pareidolia/slopes.h"

namespace cydonia::pareidolia {
namespace {

// Lit land falls at this share of the light's own slope on average, so that it casts no
// shadow.
constexpr double kLitShare = 0.44;
// The slope of a crest's flanks where the land around it is kept low.
constexpr double kCrestSlope = 3.0;
// The relief of the land has wavelengths from the grain to sixteen times its length.
constexpr int kGrainOctaves = 5;
// The width of the anti-shadow band (step 4), as a share of the terrain's width.
constexpr double kAntiShadowReach = 0.03;
// The steep side of a crest takes this share of its shadow. Beyond it the land may be
// gentle again.
constexpr double kScarpShare = 0.5;
// Holes stand this many thesis units above the shadow line (section 5.3.2) and fall by
// this share of the light's slope.
constexpr double kAbove = 0.5, kHoleFall = 0.6;

Field<float> maximum(Field<float> a, const Field<float>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::max(a[i], b[i]);
    return a;
}

Field<float> minimum(Field<float> a, const Field<float>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::min(a[i], b[i]);
    return a;
}

// `field` with the values of `over` where it has any.
Field<float> overlaid(Field<float> field, const Field<float>& over) {
    for (std::size_t i = 0; i < field.size(); ++i)
        if (over[i] != kNowhere) field[i] = over[i];
    return field;
}

Field<float> without(Field<float> field, const Field<float>& holes) {
    for (std::size_t i = 0; i < field.size(); ++i)
        if (holes[i] != kNowhere) field[i] = kNowhere;
    return field;
}

// The relief inside the shadows, 0 to 1.
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

    const bool iterative = options.features.holes == Holes::kIterative;
    const RegionTree tree = iterative ? region_tree(image.target) : RegionTree{};
    const Field<std::uint8_t> filled = iterative ? filled_shadows(tree) : image.target;
    const auto lines_over = [&](const Field<float>& ground) {
        return iterative
                   ? lines_of_regions(plan, tree, ground,
                                      thesis_units(kAbove).in(base.width()), kHoleFall)
                   : lines_of_runs(plan, ground);
    };

    // Complementary land is made first because shadows end on it.
    const ShadowLines lowest = lines_over(land);
    const float highest = *std::max_element(lowest.crests.begin(), lowest.crests.end());
    const Field<std::uint8_t> band = anti_shadow(image.target, kAntiShadowReach * width);
    Field<float> bound =
        height_bound(land, filled, band, image.sun.azimuth, plan.rise, highest);
    if (iterative) bound = overlaid(std::move(bound), lowest.holes);
    const distance::Graph layout = distance::layout_graph(graph, edges, edge_seed);
    const Field<float> secondary =
        secondary_features(options, layout, land, bound, band, context.seed);
    Field<float> ground = maximum(land, spread(sloped(uniform(lit)), secondary));
    context.progress->report(0.4);

    const ShadowLines lines = lines_over(ground);
    Field<float> primary = primary_features(plan, lines.crests);
    Field<float> generators = primary;
    if (iterative) {
        // Holes have points instead of crests.
        primary = without(std::move(primary), lines.holes);
        generators = maximum(primary, hole_points(lines.holes, context.seed));
        ground = overlaid(std::move(ground), lines.holes);
    }
    const Field<float> profiles = constant_profiles(primary, base.spacing, mean);
    // The four passes are independent of one another.
    Field<float> heights, below_ends, below_crests, buttresses;
    const double scarp = iterative ? 1.0 : kScarpShare;
    tbb::parallel_invoke(
        [&] {
            heights =
                spread(sloped(flank_slopes(plan, lit, 1.0, scarp)), generators, profiles);
        },
        [&] {
            below_ends =
                ceiling(sloped(end_slopes(plan, filled, lit)), shadow_ends(plan, ground));
        },
        [&] { below_crests = ceiling(sloped(crest_slopes(plan, filled, lit)), primary); },
        [&] { buttresses = spread(sloped(uniform(kCrestSlope / mean)), primary); });
    context.progress->report(0.8);

    heights = maximum(std::move(heights), ground);
    heights = minimum(std::move(heights), below_ends);
    heights = minimum(std::move(heights), below_crests);
    heights = maximum(std::move(heights), buttresses);
    heights =
        minimum(std::move(heights),
                shadow_ceiling(plan, lines.crests, inside_relief(plan, context.seed)));
    heights = overlaid(std::move(heights), primary);
    if (iterative) heights = overlaid(std::move(heights), lines.holes);
    context.progress->report(1.0);
    return heights;
}

}  // namespace cydonia::pareidolia
