#include "synth/geometry/shape.h"

#include <map>

#include "field/error.h"
#include "field/svg_paths.h"

namespace cydonia::geometry {
namespace {

// How far straight lines may stray from a curve, as a share of a cell.
constexpr double kTolerance = 0.02;
constexpr double kFarthest = 1e9;  // metres
constexpr std::size_t kMostPoints = 200'000;

// The Bezier curve from b to c of a centripetal Catmull-Rom curve through a, b, c, d.
std::array<Point2, 4> bezier(const Point2& a, const Point2& b, const Point2& c,
                             const Point2& d) {
    // Its parameter advances by the square roots of the distances.
    const double u = std::sqrt(distance(a, b)), v = std::sqrt(distance(b, c)),
                 w = std::sqrt(distance(c, d));
    std::array<Point2, 4> p{b, b, c, c};
    for (int i = 0; i < 2; ++i) {
        p[1][i] = (u * u * c[i] - v * v * a[i] + (2 * u * u + 3 * u * v + v * v) * b[i]) /
                  (3 * u * (u + v));
        p[2][i] = (w * w * b[i] - v * v * d[i] + (2 * w * w + 3 * w * v + v * v) * c[i]) /
                  (3 * w * (w + v));
    }
    return p;
}

std::vector<Point2> without_repeats(std::vector<Point2> points) {
    points.erase(std::unique(points.begin(), points.end(),
                             [](const Point2& a, const Point2& b) {
                                 return distance(a, b) < 1e-6;
                             }),
                 points.end());
    return points;
}

std::vector<NamedShape> drawn(const Curve& curve, const Ground& ground) {
    const double side = std::max(ground.width, ground.depth);
    const auto paths = svg_paths(*curve.drawing, kTolerance * ground.spacing / side);
    std::vector<NamedShape> shapes;
    std::string known;
    std::map<std::string, int> used;
    for (const SvgPath& path : paths) {
        known += (known.empty() ? "" : ", ") + path.id;
        if (!curve.id.empty() && !path.is_called(curve.id)) continue;
        std::vector<Point2> points;
        for (const Point2& p : path.points)
            points.push_back({p[0] * ground.width, (1.0 - p[1]) * ground.depth});
        const std::string part = path.id.empty() ? "path" : path.id;
        const int repeat = ++used[part];
        std::string name = curve.name + "/" + part;
        if (repeat > 1) name += fmt::format(" {}", repeat);
        shapes.push_back({name, shape_through(points, name)});
    }
    if (!shapes.empty()) return shapes;
    if (paths.empty())
        throw bad_request("{}: curve '{}': nothing is drawn",
                          curve.drawing->path.string(), curve.name);
    throw bad_request("{}: curve '{}': no path has the id '{}'; there are {}",
                      curve.drawing->path.string(), curve.name, curve.id,
                      known.substr(0, 200));
}

}  // namespace

Point2 Shape::at(double metres_along) const {
    const auto after = std::upper_bound(along.begin() + 1, along.end() - 1, metres_along);
    const auto i = static_cast<std::size_t>(after - along.begin());
    const double share = (metres_along - along[i - 1]) / (along[i] - along[i - 1]);
    return between(points[i - 1], points[i], std::clamp(share, 0.0, 1.0));
}

Box Shape::box() const {
    Box box = Box::of(points[0], points[1]);
    for (const Point2& p : points) box = box.with(Box::of(p, p));
    return box;
}

Shape shape_through(std::vector<Point2> points, const std::string& name) {
    for (const Point2& p : points)
        if (!(std::abs(p[0]) < kFarthest && std::abs(p[1]) < kFarthest))
            throw bad_request("curve '{}' leaves the terrain by a million kilometres",
                              name);
    if (points.size() == 1)
        throw bad_request("curve '{}' has one point: give it two or more", name);
    Shape shape{without_repeats(std::move(points)), {0.0}, {}, false};
    if (shape.points.size() < 2)
        throw bad_request("curve '{}' has no length: its points are all one place", name);
    if (shape.points.size() > kMostPoints)
        throw bad_request("curve '{}' has more than {} points", name, kMostPoints);

    const std::vector<Point2>& p = shape.points;
    for (std::size_t i = 1; i < p.size(); ++i)
        shape.along.push_back(shape.along.back() + distance(p[i - 1], p[i]));
    shape.closed = p.size() > 3 && distance(p.front(), p.back()) < 1e-6;
    if (shape.closed) shape.points.back() = shape.points.front();

    std::vector<Point2> lines;  // directions
    for (std::size_t i = 1; i < p.size(); ++i)
        lines.push_back(unit_of(from_to(p[i - 1], p[i])));
    for (std::size_t i = 0; i < p.size(); ++i) {
        const bool first = i == 0, last = i + 1 == p.size();
        const Point2 before =
            first ? (shape.closed ? lines.back() : lines[0]) : lines[i - 1];
        const Point2 after = last ? (shape.closed ? lines[0] : lines.back()) : lines[i];
        const Point2 sum{before[0] + after[0], before[1] + after[1]};
        shape.tangents.push_back(length(sum) > 1e-9 ? unit_of(sum) : after);
    }
    return shape;
}

std::vector<Point2> smooth_through(const std::vector<Point2>& given, double tolerance) {
    const std::vector<Point2> points = without_repeats(given);
    const auto n = static_cast<std::ptrdiff_t>(points.size());
    if (n < 3) return points;
    const bool ring = n > 3 && distance(points.front(), points.back()) < 1e-6;
    // Beyond an end the curve is continued by reflection.
    const auto point = [&](std::ptrdiff_t i) {
        if (i < 0) return ring ? points[n - 2] : between(points[1], points[0], 2.0);
        if (i >= n) return ring ? points[1] : between(points[n - 2], points[n - 1], 2.0);
        return points[i];
    };
    std::vector<Point2> smooth{points[0]};
    for (std::ptrdiff_t i = 0; i + 1 < n; ++i)
        flatten(bezier(point(i - 1), point(i), point(i + 1), point(i + 2)), tolerance,
                smooth);
    return smooth;
}

std::vector<NamedShape> shapes_of(const Curve& curve, const Ground& ground) {
    if (curve.drawing) return drawn(curve, ground);
    std::vector<Point2> points;
    for (const Place2& place : curve.points)
        points.push_back({place[0].in(ground.width), place[1].in(ground.depth)});
    if (points.empty()) throw bad_request("curve '{}' has no points", curve.name);
    // This checks the points before they are smoothed, so that the number of smooth ones
    // stays bounded.
    shape_through(points, curve.name);
    return {
        {curve.name,
         shape_through(smooth_through(points, kTolerance * ground.spacing), curve.name)}};
}

}  // namespace cydonia::geometry
