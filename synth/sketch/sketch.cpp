#include "synth/sketch/sketch.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "field/error.h"
#include "field/random.h"
#include "field/smoothstep.h"
#include "synth/sketch/bands.h"
#include "synth/sketch/dependents.h"
#include "synth/sketch/landform.h"
#include "synth/sketch/noise_source.h"
#include "synth/sketch/plan.h"
#include "synth/sketch/region.h"
#include "synth/sketch/stroke.h"

namespace cydonia::sketch {
namespace {

// The largest distance of the land from the silhouette, except at the ends, where it
// blends into the land before.
double most_off(const Landform& landform, const Land& land) {
    constexpr int kEnds = 4;
    const int values = landform.silhouette.width();
    double most = 0.0;
    for (int i = kEnds; i < values - kEnds; ++i)
        most = std::max(most, std::abs(land.along(landform.shadow, i, values) -
                                       landform.silhouette[std::size_t(i)]));
    return most;
}

// Makes the stroke the landform's skyline to the pixel: moves its crest into the lines of
// sight and removes whatever would be visible above them.
void keep_to(const Sight& sight, const Plan& plan,
             const std::vector<std::vector<Foot>>& feet, const Field<float>& before,
             Land& land) {
    constexpr double kCrest = 1.5, kFoot = 3.0, kRough = 10.0, kEnds = 2.0;  // samples
    constexpr int kFineBands = 3;
    const double spacing = land.ground.spacing;
    const Field<float> smooth = smoothed(land.heights, kFineBands)[0];
    for (std::size_t k = 0; k < feet.size(); ++k) {
        const Landform& landform = plan.landforms[k];
        double roughness = 1e-6;
        const auto bands = std::span(landform.noise);
        for (const double sigma :
             bands.last(std::min(bands.size(), std::size_t(kFineBands))))
            roughness += 2.0 * sigma;
        const double step =
            landform.shadow.length() / spacing / (landform.silhouette.width() - 1);
        for (const Foot& foot : feet[k]) {
            const int x = int(foot.index) % land.heights.width(),
                      y = int(foot.index) / land.heights.width();
            const Point2 place{spacing * (x + 0.5),
                               spacing * (land.heights.height() - y - 0.5)};
            const double begin = landform.goes_on[0] ? kEnds : step * double(foot.place),
                         end = landform.goes_on[1] ? kEnds
                                                   : step * (landform.silhouette.width() -
                                                             1 - double(foot.place));
            float& height = land.heights[foot.index];
            if (const auto line = sight.height_over(place)) {
                const double crest = smoothstep(kFoot, kCrest, double(foot.distance)) *
                                     smoothstep(0.0, kEnds, std::min(begin, end));
                height += float(crest * (*line - height));
            }
            // The crest's teeth fade with the distance from it; otherwise they would
            // become long furrows along the lines of sight.
            const double away = std::max(0.0, double(foot.distance) - kFoot) * spacing;
            const auto line = sight.height_below(place, 0.5 * away);
            if (!line) continue;
            // Land that was above the line before may stay, but not rise.
            const double most = std::max(*line, double(before[foot.index]));
            const double above = height - most;
            if (above <= 0.0) continue;
            // The land keeps its roughness below the line, as it is seen from other
            // directions, too.
            const double rise = land.heights[foot.index] - smooth[foot.index];
            const double lower = roughness *
                                 (1.0 - std::clamp(rise / roughness, -1.0, 1.0)) *
                                 smoothstep(kFoot, kRough, double(foot.distance));
            height = float(most - std::min(above, lower));
        }
    }
}

// Makes a land, landform by landform.
class Making {
  public:
    Making(const Options& options, const Terrain& terrain, const Context& context)
        : options_(options),
          context_(context),
          result_(terrain),
          land_{terrain.heights, {terrain.width(), terrain.depth(), terrain.spacing}},
          noise_(options, terrain, context),
          stack_(terrain.heights, options.features) {}

    void add(std::size_t number) {
        const Feature& feature = options_.features[number];
        Progress& progress = *context_.progress;
        const Field<float> seen =
            feature.view ? stack_.without(land_.heights, feature.view->through)
                         : Field<float>{};
        Plan plan = plan_of(feature, land_, seen, options_, progress);
        const Noise noise =
            noise_.of(plan.landforms, land_.heights,
                      hash_of({context_.seed, key("sketch"), key(feature.name)}));
        const Field<float> before = land_.heights;
        const auto feet = deform(land_.heights, land_.ground.spacing, plan.landforms,
                                 int(plan.landforms[0].noise.size()), noise);
        if (plan.sight) {
            keep_to(*plan.sight, plan, feet, before, land_);
            settle(land_.heights, land_.ground.spacing, plan.landforms, feet);
        }
        if (plan.sight && !has_way(feature)) warn_of_hidden_ends(feature, plan);
        stack_.add(number, feet, before);
        for (std::size_t k = 0; k < plan.ways.size(); ++k)
            result_.figures["sketch: '" + plan.ways[k].name +
                            "' off its silhouette, most, m"] =
                most_off(plan.landforms[k], land_);
        if (plan.sight)
            result_.figures["sketch: '" + feature.name +
                            "' off its stroke in the view, on average, px"] =
                plan.sight->skyline_off(land_.heights, before, land_.ground.spacing,
                                        covered(feet));
    }

    void roughen_region(const RoughRegion& region) {
        const double spacing = land_.ground.spacing;
        const int values = values_along(region.length.in(land_.ground.width), spacing);
        const NoiseLevels noise =
            noise_of(heights_of(region.noise, values, region.name, *context_.progress),
                     options_.levels, region.noise.mouse);
        int part = 0;
        for (const geometry::NamedShape& named :
             ways_of(region.name, region.way, land_, *context_.progress)) {
            if (named.shape.segments() < 3)
                throw bad_request("region '{}' has no area: give its loop more points",
                                  named.name);
            roughen(land_.heights, spacing, named.shape, noise, options_.levels,
                    hash_of({context_.seed, key("sketch"), key(region.name),
                             std::uint64_t(part++)}));
        }
    }

    Terrain done() && {
        if (context_.memory) stack_.compare(*context_.memory, *context_.progress);
        result_.heights = std::move(land_.heights);
        return std::move(result_);
    }

  private:
    std::vector<bool> covered(const std::vector<std::vector<Foot>>& feet) const {
        std::vector<bool> samples(land_.heights.size());
        for (const auto& of_one : feet)
            for (const Foot& foot : of_one) samples[foot.index] = true;
        return samples;
    }
    // To be called before the feature is added to the stack.
    void warn_of_hidden_ends(const Feature& feature, const Plan& plan) const {
        const double spacing = land_.ground.spacing;
        const geometry::Shape& shadow = plan.landforms[0].shadow;
        for (const Point2& p : {shadow.points.front(), shadow.points.back()}) {
            const int x = std::clamp(int(p[0] / spacing), 0, land_.heights.width() - 1);
            const int y = std::clamp(int(land_.heights.height() - p[1] / spacing), 0,
                                     land_.heights.height() - 1);
            const std::string& on = stack_.on_top(land_.heights.index(x, y));
            if (!on.empty() && std::ranges::find(feature.view->through, on) ==
                                   feature.view->through.end())
                context_.progress->note(fmt::format(
                    "'{}' ends on '{}'; if it is to end behind it: through = [\"{}\"]",
                    feature.name, on, on));
        }
    }

    const Options& options_;
    const Context& context_;
    Terrain result_;
    Land land_;
    NoiseSource noise_;
    Stack stack_;
};

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    Progress& progress = *context.progress;
    Making making(options, terrain, context);
    progress.step("sketch: landforms");
    for (std::size_t i = 0; i < options.features.size(); ++i) {
        making.add(i);
        progress.report(double(i + 1) / double(options.features.size()));
    }
    if (!options.regions.empty()) progress.step("sketch: regions");
    for (const RoughRegion& region : options.regions) making.roughen_region(region);
    return std::move(making).done();
}

}  // namespace cydonia::sketch
