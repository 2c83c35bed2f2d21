#include "synth/sketch/plan.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "field/error.h"
#include "synth/geometry/course.h"
#include "synth/geometry/nearest.h"
#include "synth/sketch/boundary.h"
#include "synth/sketch/landform.h"
#include "synth/sketch/stroke.h"

namespace cydonia::sketch {
namespace {

constexpr double kTypicalSlope = 30.0;  // degrees (docs/papers.md, Gain 2009, 2)
constexpr double kMostValues = 65536.0;
constexpr std::size_t kMostWays = 256;  // of a landform

geometry::Curve curve_of(const std::string& name, const Way& way) {
    geometry::Curve curve{.name = name};
    curve.points = way.points, curve.drawing = way.drawing, curve.id = way.id;
    return curve;
}

geometry::Curve curve_of(const Feature& feature) {
    geometry::Curve curve = curve_of(feature.name, feature.way);
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

// The shadow of a silhouette in a view for which no way is given: the straight line
// between its ends as they are cast on the land.
geometry::Shape default_shadow(const Feature& feature, const Sight& sight,
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
    if (geometry::distance(ends[0], ends[1]) < 4.0 * land.ground.spacing)
        throw bad_request(
            "{}: '{}': the ends of its stroke are cast on one place of the land",
            feature.view->drawing.name(), feature.name);
    return geometry::shape_through(std::move(ends), feature.name);
}

double most_above(const Landform& landform, const Land& land) {
    double most = 0.0;
    for (int i = 0; i < landform.silhouette.width(); ++i)
        most = std::max(
            most, std::abs(landform.silhouette[std::size_t(i)] -
                           land.along(landform.shadow, i, landform.silhouette.width())));
    return most;
}

void set_boundary(Landform& landform, const Feature& feature,
                  const std::shared_ptr<geometry::Course>& course, const Land& land,
                  Progress& progress) {
    if (feature.boundary_curve) {
        landform.boundary = drawn_boundary(
            landform.shadow,
            geometry::shapes_of(curve_of(feature.name, *feature.boundary_curve),
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

// The position on another way of the same feature where an end of a way lies.
struct Joint {
    std::size_t way;
    double share;  // of the other way's length
};
using Joints = std::array<std::optional<Joint>, 2>;

// Joins ways with those before them, and moves their ends onto these.
std::vector<Joints> joined(std::vector<geometry::NamedShape>& ways,
                           const geometry::Ground& ground) {
    constexpr double kReach =
        0.02;  // share of the terrain's width: gaps that a hand leaves open
    std::vector<Joints> joints(ways.size());
    for (std::size_t k = 1; k < ways.size(); ++k) {
        if (ways[k].shape.closed) continue;
        for (const std::size_t end : {0u, 1u}) {
            std::vector<Point2> points = ways[k].shape.points;
            const Point2 p = end == 0 ? points.front() : points.back();
            double nearest = kReach * ground.width;
            Point2 at = p;
            for (std::size_t other = 0; other < k; ++other) {
                const geometry::Shape& way = ways[other].shape;
                for (std::size_t s = 0; s + 1 < way.points.size(); ++s) {
                    const Point2 &a = way.points[s], &b = way.points[s + 1];
                    const double t = geometry::nearest_share(a, b, p);
                    const Point2 there = geometry::between(a, b, t);
                    if (geometry::distance(p, there) >= nearest) continue;
                    nearest = geometry::distance(p, there), at = there;
                    joints[k][end] = {
                        other, (way.along[s] + t * (way.along[s + 1] - way.along[s])) /
                                   way.length()};
                }
            }
            if (!joints[k][end] || nearest < 0.01 * ground.spacing) continue;
            points.insert(end == 0 ? points.begin() : points.end(), at);
            ways[k].shape = geometry::shape_through(std::move(points), ways[k].name);
        }
    }
    return joints;
}

Landform landform_of(const Feature& feature, const geometry::NamedShape& named,
                     const Joints& joints, const std::optional<Sight>& sight,
                     const Land& land, int levels, Progress& progress) {
    const auto course = std::make_shared<geometry::Course>(
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

// A branch begins and ends at the height of the way that it joins.
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

// The number of levels whose widest scale is at most a quarter of the way. A landform has
// nothing on wider scales, and would become a fin as narrow as the finest.
int levels_of(const std::vector<geometry::NamedShape>& ways, double spacing,
              const Options& options) {
    double longest = 0.0;
    for (const geometry::NamedShape& way : ways)
        longest = std::max(longest, way.shape.length());
    return std::clamp(int(std::log2(0.25 * longest / spacing)), 1, options.levels);
}

}  // namespace

int values_along(double length, double spacing) {
    return int(std::clamp(std::ceil(length / spacing), 8.0, kMostValues)) + 1;
}

bool has_way(const Feature& feature) {
    return !feature.way.points.empty() || feature.way.drawing;
}

std::vector<geometry::NamedShape> ways_of(const std::string& name, const Way& way,
                                          const Land& land, Progress& progress) {
    auto shapes = geometry::shapes_of(curve_of(name, way), land.ground);
    if (shapes.size() == 1) shapes[0].name = name;
    if (shapes.size() > kMostWays)
        throw bad_request("'{}': {} paths are too many for one; at most {}", name,
                          shapes.size(), kMostWays);
    for (geometry::NamedShape& named : shapes)
        if (const int loops = cut_loops(named.shape.points)) {
            named.shape =
                geometry::shape_through(std::move(named.shape.points), named.name);
            progress.note(fmt::format("'{}': its way crosses itself; {} cut off",
                                      named.name,
                                      loops == 1 ? "a loop is" : "loops are"));
        }
    return shapes;
}

Plan plan_of(const Feature& feature, const Land& land, const Field<float>& seen_through,
             const Options& options, Progress& progress) {
    Plan plan;
    if (feature.view) plan.sight.emplace(*feature.view, feature.name, progress);
    if (has_way(feature)) {
        plan.ways = ways_of(feature.name, feature.way, land, progress);
    } else {
        const Land through{seen_through, land.ground};
        plan.ways = {
            {feature.name, default_shadow(feature, *plan.sight, through, progress)}};
    }
    if (feature.view && has_way(feature))
        for (geometry::NamedShape& named : plan.ways) {
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

}  // namespace cydonia::sketch
