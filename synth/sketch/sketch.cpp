#include "synth/sketch/sketch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "field/error.h"
#include "field/random.h"
#include "field/sample.h"
#include "synth/sketch/landform.h"
#include "synth/sketch/region.h"
#include "synth/sketch/stroke.h"
#include "synth/texture/course.h"

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

struct Land {
    Field<float> heights;
    texture::Ground ground;

    double at(double east, double north) const {
        return bilinear(heights, east / ground.spacing - 0.5,
                        heights.height() - north / ground.spacing - 0.5);
    }
    double along(const texture::Shape& shape, int i, int values) const {
        const Point2 p = shape.at(shape.length() * i / (values - 1));
        return at(p[0], p[1]);
    }
};

int values_along(double length, double spacing) {
    return int(std::clamp(std::ceil(length / spacing), 8.0, kMostValues)) + 1;
}

Landform landform_of(const Feature& feature, const texture::NamedShape& named,
                     const Land& land, Progress& progress) {
    const auto course = std::make_shared<texture::Course>(
        curve_of(feature), named.name, named.shape, land.ground, nullptr);
    const double length = named.shape.length();
    const int values = values_along(length, land.ground.spacing);
    Landform landform{named.shape, Field<float>(values, 1), {}, false};
    if (feature.silhouette) {
        landform.silhouette =
            heights_of(*feature.silhouette, values, named.name, progress);
        landform.mouse = feature.silhouette->mouse;
    }
    double most = 0.0;
    for (int i = 0; i < values; ++i) {
        float& height = landform.silhouette[std::size_t(i)];
        const double there = land.along(named.shape, i, values);
        height += float(course->height(length * i / (values - 1)) +
                        (feature.relative ? there : 0.0));
        most = std::max(most, std::abs(height - there));
    }
    const double half = 0.5 * most / std::tan(kTypicalSlope * std::numbers::pi / 180.0);
    if (!has_boundary(feature))
        landform.boundary = [half](double) { return std::array{half, half}; };
    else
        landform.boundary = [course](double along) { return course->at(along).area; };
    return landform;
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

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    Progress& progress = *context.progress;
    Terrain result = terrain;
    Land land{terrain.heights, {terrain.width(), terrain.depth(), terrain.spacing}};
    std::uint64_t number = 0;
    const auto seed = [&] { return hash_of({context.seed, key("sketch"), number++}); };
    progress.step("sketch: landforms");
    for (std::size_t i = 0; i < options.features.size(); ++i) {
        const Feature& feature = options.features[i];
        auto shapes = texture::shapes_of(curve_of(feature), land.ground);
        if (shapes.size() == 1) shapes[0].name = feature.name;
        for (const texture::NamedShape& named : shapes) {
            const Landform landform = landform_of(feature, named, land, progress);
            deform(land.heights, terrain.spacing, landform, options.levels, seed());
            result.figures["sketch: '" + named.name + "' off its silhouette, most, m"] =
                most_off(landform, land);
        }
        progress.report(double(i + 1) / double(options.features.size()));
    }
    for (const Region& region : options.regions) {
        progress.step("sketch: regions");
        const int values =
            values_along(region.length.in(terrain.width()), terrain.spacing);
        const NoiseLevels noise =
            noise_of(heights_of(region.noise, values, region.name, progress),
                     options.levels, region.noise.mouse);
        for (const texture::NamedShape& named :
             texture::shapes_of(curve_of(region.name, region.way), land.ground)) {
            if (named.shape.segments() < 3)
                throw bad_request("region '{}' has no area: give its loop more points",
                                  named.name);
            roughen(land.heights, terrain.spacing, named.shape, noise, options.levels,
                    seed());
        }
    }
    result.heights = std::move(land.heights);
    return result;
}

}  // namespace cydonia::sketch
