#include "synth/sketch/sketch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>

#include "field/dem.h"
#include "field/error.h"
#include "field/files.h"
#include "field/random.h"
#include "field/sample.h"
#include "field/smoothstep.h"
#include "synth/detail/detail.h"
#include "synth/sketch/bands.h"
#include "synth/sketch/boundary.h"
#include "synth/sketch/dependents.h"
#include "synth/sketch/landform.h"
#include "synth/sketch/region.h"
#include "synth/sketch/sight.h"
#include "synth/sketch/stroke.h"
#include "synth/texture/course.h"
#include "synth/texture/nearest.h"
#include "synth/texture/texture.h"

namespace cydonia::sketch {
namespace {

constexpr double kTypicalSlope = 30.0;  // degrees (notes.md, Gain 2009, 2)
constexpr double kMostValues = 65536.0;

texture::Curve curve_of(const std::string& name, const Way& way) {
    texture::Curve curve{.name = name};
    curve.points = way.points, curve.drawing = way.drawing, curve.id = way.id;
    return curve;
}

texture::Curve curve_of(const Feature& feature) {
    texture::Curve curve = curve_of(feature.name, feature.way);
    curve.height = feature.height;
    curve.area = feature.boundary.value_or(curve.area);
    for (const Hold& hold : feature.holds)
        curve.handles.push_back({hold.at, hold.height, {}, hold.boundary});
    return curve;
}

bool has_boundary(const Feature& feature) {
    return feature.boundary || std::ranges::any_of(feature.holds, [](const Hold& hold) {
               return hold.boundary.has_value();
           });
}

bool has_way(const Feature& feature) {
    return !feature.way.points.empty() || feature.way.drawing;
}

struct Land {
    Field<float> heights;
    texture::Ground ground;

    double at(double east, double north) const {
        return bilinear(heights, east / ground.spacing - 0.5,
                        heights.height() - north / ground.spacing - 0.5);
    }
    // Whether a way that ends there is pinned to the terrain's side.
    bool is_edge(const Point2& p) const {
        const double margin = ground.spacing;
        return p[0] < margin || p[1] < margin || p[0] > ground.width - margin ||
               p[1] > ground.depth - margin;
    }
    double along(const texture::Shape& shape, int i, int values) const {
        const Point2 p = shape.at(shape.length() * i / (values - 1));
        return at(p[0], p[1]);
    }
};

int values_along(double length, double spacing) {
    return int(std::clamp(std::ceil(length / spacing), 8.0, kMostValues)) + 1;
}

std::vector<texture::NamedShape> ways_of(const texture::Curve& curve, const Land& land,
                                         Progress& progress) {
    auto shapes = texture::shapes_of(curve, land.ground);
    if (shapes.size() == 1) shapes[0].name = curve.name;
    for (texture::NamedShape& named : shapes)
        if (const int loops = cut_loops(named.shape.points)) {
            named.shape =
                texture::shape_through(std::move(named.shape.points), named.name);
            progress.note(fmt::format("'{}': its way crosses itself; {} cut off",
                                      named.name,
                                      loops == 1 ? "a loop is" : "loops are"));
        }
    return shapes;
}

// Where the shadow of a silhouette in a view runs that has none of its own: straight
// between its ends as they are cast on the land.
texture::Shape default_shadow(const Feature& feature, const Sight& sight,
                              const Land& land, Progress& progress) {
    std::vector<Point2> ends;
    for (const std::size_t end : {0u, 1u}) {
        const std::string_view side = end == 0 ? "left" : "right";
        const auto landing = landing_of(land.heights, land.ground.spacing, sight.eye(),
                                        sight.eye_height(), sight.ends()[end]);
        if (!landing)
            throw bad_request(
                "{}: '{}': the {} end of its stroke is beside the terrain: end it over "
                "land, or give the landform points of its own",
                feature.view->drawing.name(), feature.name, side);
        if (landing->on_wall)
            progress.note(fmt::format(
                "'{}': the {} end of its stroke is above the land: it goes on to the "
                "terrain's edge",
                feature.name, side));
        ends.push_back(landing->place);
    }
    if (texture::distance(ends[0], ends[1]) < 4.0 * land.ground.spacing)
        throw bad_request(
            "{}: '{}': the ends of its stroke are cast on one place of the land",
            feature.view->drawing.name(), feature.name);
    return texture::shape_through(std::move(ends), feature.name);
}

// What the landforms of one feature are made with.
struct Plan {
    std::vector<texture::NamedShape> ways;
    std::vector<Landform> landforms;
    std::optional<Sight> sight;
};

double most_above(const Landform& landform, const Land& land) {
    double most = 0.0;
    for (int i = 0; i < landform.silhouette.width(); ++i)
        most = std::max(
            most, std::abs(landform.silhouette[std::size_t(i)] -
                           land.along(landform.shadow, i, landform.silhouette.width())));
    return most;
}

void set_boundary(Landform& landform, const Feature& feature,
                  const std::shared_ptr<texture::Course>& course, const Land& land,
                  Progress& progress) {
    if (feature.boundary_curve) {
        landform.boundary = drawn_boundary(
            landform.shadow,
            texture::shapes_of(curve_of(feature.name, *feature.boundary_curve),
                               land.ground),
            land.ground.spacing, feature.name, progress);
    } else if (has_boundary(feature)) {
        landform.boundary =
            rounded([course](double along) { return course->at(along).area; },
                    landform.shadow.length(), landform.goes_on);
    } else if (feature.view) {
        landform.boundary = capsule(landform.silhouette, landform.shadow.length());
    } else {
        const double half = 0.5 * most_above(landform, land) /
                            std::tan(kTypicalSlope * std::numbers::pi / 180.0);
        landform.boundary = rounded(
            [half](double) {
                return std::array{half, half};
            },
            landform.shadow.length(), landform.goes_on);
    }
}

// Where an end of a way lies on another way of the same feature.
struct Joint {
    std::size_t way;
    double share;  // of that
};
using Joints = std::array<std::optional<Joint>, 2>;

// Of ways with those before them; leads their ends onto these.
std::vector<Joints> joined(std::vector<texture::NamedShape>& ways,
                           const texture::Ground& ground) {
    constexpr double kReach = 0.02;  // of the terrain's width: what a hand leaves open
    std::vector<Joints> joints(ways.size());
    for (std::size_t k = 1; k < ways.size(); ++k)
        for (const std::size_t end : {0u, 1u}) {
            std::vector<Point2> points = ways[k].shape.points;
            const Point2 p = end == 0 ? points.front() : points.back();
            double nearest = kReach * ground.width;
            Point2 at = p;
            for (std::size_t other = 0; other < k; ++other) {
                const texture::Shape& way = ways[other].shape;
                for (std::size_t s = 0; s + 1 < way.points.size(); ++s) {
                    const Point2 &a = way.points[s], &b = way.points[s + 1];
                    const double t = texture::nearest_share(a, b, p);
                    const Point2 there = texture::between(a, b, t);
                    if (texture::distance(p, there) >= nearest) continue;
                    nearest = texture::distance(p, there), at = there;
                    joints[k][end] = {
                        other, (way.along[s] + t * (way.along[s + 1] - way.along[s])) /
                                   way.length()};
                }
            }
            if (!joints[k][end] || nearest < 0.01 * ground.spacing) continue;
            points.insert(end == 0 ? points.begin() : points.end(), at);
            ways[k].shape = texture::shape_through(std::move(points), ways[k].name);
        }
    return joints;
}

Landform landform_of(const Feature& feature, const texture::NamedShape& named,
                     const Joints& joints, const std::optional<Sight>& sight,
                     const Land& land, int levels, Progress& progress) {
    const auto course = std::make_shared<texture::Course>(
        curve_of(feature), named.name, named.shape, land.ground, nullptr);
    const double length = named.shape.length();
    const int values = values_along(length, land.ground.spacing);
    Landform landform{named.shape, Field<float>(values, 1), {}, {}, {}};
    const bool mouse =
        sight ? feature.view->mouse : feature.silhouette && feature.silhouette->mouse;
    if (feature.silhouette)
        landform.silhouette =
            heights_of(*feature.silhouette, values, named.name, progress);
    for (int i = 0; i < values; ++i) {
        float& height = landform.silhouette[std::size_t(i)];
        if (sight)
            height = float(sight->height_over(named.shape.at(length * i / (values - 1)))
                               .value_or(height));
        else
            height +=
                float(course->height(length * i / (values - 1)) +
                      (feature.relative ? land.along(named.shape, i, values) : 0.0));
    }
    landform.noise = noise_of(landform.silhouette, levels, mouse).fitted;
    landform.goes_on = {
        named.shape.closed || joints[0] || land.is_edge(named.shape.points.front()),
        named.shape.closed || joints[1] || land.is_edge(named.shape.points.back())};
    set_boundary(landform, feature, course, land, progress);
    return landform;
}

// Branches begin and end as high as the way that they leave or come to.
void join(std::vector<Landform>& landforms, const std::vector<Joints>& joints) {
    for (std::size_t k = 1; k < landforms.size(); ++k) {
        Field<float>& branch = landforms[k].silhouette;
        const int last = branch.width() - 1;
        for (const std::size_t end : {0u, 1u}) {
            if (!joints[k][end]) continue;
            const Field<float>& way = landforms[joints[k][end]->way].silhouette;
            const auto at =
                std::size_t(std::lround(joints[k][end]->share * double(way.width() - 1)));
            const float off = way[at] - branch[end == 0 ? 0 : std::size_t(last)];
            for (int i = 0; i <= last; ++i) {
                const float t = float(end == 0 ? last - i : i) / float(last);
                branch[std::size_t(i)] += off * t * t * (3.0f - 2.0f * t);
            }
        }
    }
}

// Those whose widest scale, a quarter of the way, is one that the landform has: of a
// wider one there would be nothing, and all of it a fin as narrow as the finest.
int levels_of(const std::vector<texture::NamedShape>& ways, double spacing,
              const Options& options) {
    double longest = 0.0;
    for (const texture::NamedShape& way : ways)
        longest = std::max(longest, way.shape.length());
    return std::clamp(int(std::log2(0.25 * longest / spacing)), 1, options.levels);
}

Plan plan_of(const Feature& feature, const Land& land, const Field<float>& seen_through,
             const Options& options, Progress& progress) {
    Plan plan;
    if (feature.view) plan.sight.emplace(*feature.view, feature.name, progress);
    if (has_way(feature)) {
        plan.ways = ways_of(curve_of(feature), land, progress);
    } else {
        const Land through{seen_through, land.ground};
        plan.ways = {
            {feature.name, default_shadow(feature, *plan.sight, through, progress)}};
    }
    if (feature.view && has_way(feature))
        for (texture::NamedShape& named : plan.ways) {
            auto part =
                part_in_sight(named.shape, *plan.sight, land.ground.spacing, named.name);
            if (!part)
                throw bad_request(
                    "{}: '{}': its way does not run under its stroke as the camera sees "
                    "them",
                    feature.view->drawing.name(), named.name);
            if (part->length() < named.shape.length() - 2.0 * land.ground.spacing)
                progress.note(fmt::format(
                    "'{}': its way ends where its stroke does, as the camera sees them",
                    named.name));
            named.shape = std::move(*part);
        }
    const int levels = levels_of(plan.ways, land.ground.spacing, options);
    const std::vector<Joints> joints = joined(plan.ways, land.ground);
    for (std::size_t k = 0; k < plan.ways.size(); ++k)
        plan.landforms.push_back(landform_of(feature, plan.ways[k], joints[k], plan.sight,
                                             land, levels, progress));
    join(plan.landforms, joints);
    return plan;
}

// The most that the land is off the silhouette, without the ends, where it goes over into
// the land there was.
double most_off(const Landform& landform, const Land& land) {
    constexpr int kEnds = 4;
    const int values = landform.silhouette.width();
    double most = 0.0;
    for (int i = kEnds; i < values - kEnds; ++i)
        most = std::max(most, std::abs(land.along(landform.shadow, i, values) -
                                       landform.silhouette[std::size_t(i)]));
    return most;
}

// So that the stroke is the landform's skyline to the pixel: its crest lies in the lines
// of sight, and what would be seen above them is taken off.
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
            const auto line = sight.height_over(
                {spacing * (x + 0.5), spacing * (land.heights.height() - y - 0.5)});
            if (!line) continue;
            const double begin = landform.goes_on[0] ? kEnds : step * double(foot.place),
                         end = landform.goes_on[1] ? kEnds
                                                   : step * (landform.silhouette.width() -
                                                             1 - double(foot.place));
            const double crest = smoothstep(kFoot, kCrest, double(foot.distance)) *
                                 smoothstep(0.0, kEnds, std::min(begin, end));
            float& height = land.heights[foot.index];
            height += float(crest * (*line - height));
            // Land that stood above the line already may do so, but not rise.
            const double most = std::max(*line, double(before[foot.index]));
            const double above = height - most;
            if (above <= 0.0) continue;
            // As rough below the line as it was above, for it is seen from elsewhere too.
            const double rise = land.heights[foot.index] - smooth[foot.index];
            const double lower = roughness *
                                 (1.0 - std::clamp(rise / roughness, -1.0, 1.0)) *
                                 smoothstep(kFoot, kRough, double(foot.distance));
            height = float(most - std::min(above, lower));
        }
    }
}

// What landforms' noise is made of, as options say.
class NoiseSource {
  public:
    NoiseSource(const Options& options, const Terrain& terrain, const Context& context)
        : options_(options), context_(context), spacing_(terrain.spacing) {
        if (!options.noise_from) return;
        if (options.noise == NoiseKind::kWavelet)
            measure();
        else
            model_spacing_ = read_dem(*options.noise_from).spacing;
        if (options.noise == NoiseKind::kTexture) synthesise(terrain);
    }

    // Of a feature that is to be made on the land; sets how strong its bands are.
    Noise of(std::vector<Landform>& landforms, const Land& land, std::uint64_t seed) {
        const int levels = int(landforms[0].noise.size());
        if (!strength_.empty())
            for (Landform& landform : landforms)
                landform.noise.assign(strength_.end() - levels, strength_.end());
        const Noise plain = wavelets(land.heights, levels, seed);
        if (options_.noise == NoiseKind::kWavelet) return plain;
        if (options_.noise == NoiseKind::kTexture)
            return of_land(synthesised_, landforms, levels, plain);
        return of_land(detailed(landforms, land, levels, seed), landforms, levels, plain);
    }

  private:
    // As strong as the model's own bands, wider than its cells; finer ones by the fit.
    void measure() {
        const Terrain model = read_dem(*options_.noise_from);
        const int levels = options_.levels;
        const int finer = int(std::lround(std::log2(model.spacing / spacing_)));
        const NoiseLevels own = noise_of_land(model.heights, levels);
        // A band of the model is one of the terrain's `finer` steps wider.
        const double decay =
            std::log(own.fitted.back() / own.fitted.front()) / std::max(1, levels - 1);
        for (int i = 1; i <= levels; ++i)
            strength_.push_back(own.fitted.back() *
                                std::exp(decay * (i - levels + finer)));
    }
    // Real land sample for sample where it is coarser than the terrain: only its form
    // counts, how strong it is says the silhouette.
    double stretch() const { return std::min(1.0, spacing_ / model_spacing_); }

    void synthesise(const Terrain& terrain) {
        texture::Options options;
        options.exemplars.push_back({*options_.noise_from, {}, {}});
        options.spacing = spacing_;
        options.scale = stretch();
        synthesised_ = texture::run(options, terrain, context_).heights;
    }
    // What details by example add to the feature without noise.
    Field<float> detailed(const std::vector<Landform>& landforms, const Land& land,
                          int levels, std::uint64_t seed) const {
        std::vector<Landform> smooth = landforms;
        for (Landform& landform : smooth) std::ranges::fill(landform.noise, 0.0);
        Terrain bare;
        bare.spacing = spacing_;
        bare.heights = land.heights;
        const auto none = [&](int) {
            return Field<float>(land.heights.width(), land.heights.height());
        };
        deform(bare.heights, spacing_, smooth, levels, none);
        detail::Options options;
        options.targets.push_back({*options_.noise_from, {}, stretch()});
        options.levels = std::min(levels, 5);
        Context context = context_;
        context.seed = seed;
        Field<float> added = detail::run(options, bare, context).heights;
        for (std::size_t i = 0; i < added.size(); ++i) added[i] -= bare.heights[i];
        return added;
    }
    // The bands of a land, of mean square 1 under the feature; wavelets where it has
    // none.
    Noise of_land(const Field<float>& land, const std::vector<Landform>& landforms,
                  int levels, const Noise& plain) const {
        const auto scales =
            std::make_shared<const std::vector<Field<float>>>(smoothed(land, levels));
        std::vector<Foot> feet;
        for (const Landform& landform : landforms)
            std::ranges::copy(footprint(landform, land, spacing_),
                              std::back_inserter(feet));
        return [scales, feet = std::move(feet), plain](int i) {
            const Field<float>&fine = (*scales)[std::size_t(i)],
                  &coarse = (*scales)[std::size_t(i - 1)];
            constexpr double kLeast = 1e-3;  // metres
            double squares = 0.0, weights = 0.0;
            for (const Foot& foot : feet) {
                const double d = fine[foot.index] - coarse[foot.index];
                squares += foot.noise * d * d, weights += foot.noise;
            }
            if (!(squares > kLeast * kLeast * weights)) return plain(i);
            const float scale = float(std::sqrt(weights / squares));
            Field<float> band = fine;
            for (std::size_t k = 0; k < band.size(); ++k)
                band[k] = scale * (band[k] - coarse[k]);
            return band;
        };
    }

    const Options& options_;
    const Context& context_;
    double spacing_, model_spacing_ = 1.0;
    std::vector<double> strength_;
    Field<float> synthesised_;
};

// A land that is made landform by landform.
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
            noise_.of(plan.landforms, land_,
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

    void roughen_region(const Region& region) {
        const double spacing = land_.ground.spacing;
        const int values = values_along(region.length.in(land_.ground.width), spacing);
        const NoiseLevels noise =
            noise_of(heights_of(region.noise, values, region.name, *context_.progress),
                     options_.levels, region.noise.mouse);
        int part = 0;
        for (const texture::NamedShape& named :
             ways_of(curve_of(region.name, region.way), land_, *context_.progress)) {
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
    // Before the feature is on the stack.
    void warn_of_hidden_ends(const Feature& feature, const Plan& plan) const {
        const double spacing = land_.ground.spacing;
        const texture::Shape& shadow = plan.landforms[0].shadow;
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
    for (const Region& region : options.regions) making.roughen_region(region);
    return std::move(making).done();
}

}  // namespace cydonia::sketch
