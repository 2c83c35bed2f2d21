#include "synth/sketch/footprint.h"

#include <algorithm>
#include <cmath>

#include "synth/geometry/nearest.h"

namespace cydonia::sketch {
namespace {

constexpr double kLeastReach = 2.0;  // samples, of the finest deformations
constexpr double kMostLean =
    0.7;  // cosine of the angle between base line and shadow: 45 degrees

using geometry::cross;
using geometry::dot;
using geometry::from_to;

// The shadow as seen from stations on the line through its ends, half a sample apart.
struct BaseLine {
    struct Station {
        double along;  // position along the shadow, metres
        double aside;  // distance of the shadow to the left of the base line, metres
        double lean;   // cosine of the angle between them
        double left, right;  // distances of the boundary, metres
    };
    Point2 begin, direction;  // of length 1
    double length, step;
    std::vector<Station> stations;

    BaseLine(const Landform& landform, double spacing) {
        const geometry::Shape& shadow = landform.shadow;
        begin = shadow.points.front();
        const Point2 chord = from_to(begin, shadow.points.back());
        length = geometry::length(chord), direction = geometry::unit_of(chord);
        const int count = std::max(2, int(std::ceil(2.0 * length / spacing)));
        step = length / count;
        std::size_t s = 0;
        const auto share_of = [&](std::size_t i) {
            return dot(from_to(begin, shadow.points[i]), direction);
        };
        for (int i = 0; i <= count; ++i) {
            const double t = step * i;
            while (s + 2 < shadow.points.size() && share_of(s + 1) < t) ++s;
            const double from = share_of(s), to = share_of(s + 1);
            const double share = std::clamp((t - from) / (to - from), 0.0, 1.0);
            Station station;
            station.along =
                shadow.along[s] + share * (shadow.along[s + 1] - shadow.along[s]);
            station.aside =
                cross(direction,
                      from_to(begin, geometry::between(shadow.points[s],
                                                       shadow.points[s + 1], share)));
            // From tangents, which do not jump from line to line.
            station.lean = dot(geometry::unit_of(geometry::between(
                                   shadow.tangents[s], shadow.tangents[s + 1], share)),
                               direction);
            const auto boundary = landform.boundary(station.along);
            station.left = boundary[0], station.right = boundary[1];
            stations.push_back(station);
        }
    }
    // Interpolated between two stations.
    Station at(double t) const {
        const double k = std::clamp(t / step, 0.0, double(stations.size() - 1));
        const auto i = std::min(std::size_t(k), stations.size() - 2);
        const double f = k - double(i);
        const Station &a = stations[i], &b = stations[i + 1];
        const auto mix = [f](double from, double to) { return from + f * (to - from); };
        return {mix(a.along, b.along), mix(a.aside, b.aside), mix(a.lean, b.lean),
                mix(a.left, b.left), mix(a.right, b.right)};
    }
    double widest() const {
        double most = 0.0;
        for (const Station& p : stations)
            most = std::max({most, (std::abs(p.aside) + p.left / p.lean),
                             std::abs(p.aside) + p.right / p.lean});
        return most;
    }
};

std::vector<Foot> on_base_line(const Landform& landform, const Field<float>& land,
                               double spacing) {
    const BaseLine line(landform, spacing);
    const double widest = line.widest(), total = landform.shadow.length();
    const int values = landform.silhouette.width();
    const geometry::Grid grid{spacing,      0.0,          spacing * land.height(), 0, 0,
                              land.width(), land.height()};
    const auto range = grid.cells_in(
        geometry::Box::of(landform.shadow.points.front(), landform.shadow.points.back())
            .grown(widest));
    std::vector<Foot> feet;
    for (int y = range.y0; y < range.y1; ++y)
        for (int x = range.x0; x < range.x1; ++x) {
            const Point2 p = from_to(line.begin, grid.centre(x, y));
            const double t = dot(p, line.direction), aside = cross(line.direction, p);
            if (t < 0.0 || t > line.length || std::abs(aside) > widest) continue;
            const BaseLine::Station station = line.at(t);
            // Measured across the shadow, as boundaries are.
            const double off = (aside - station.aside) * station.lean;
            const double reach = off > 0.0 ? station.left : station.right;
            if (!(std::abs(off) < reach)) continue;
            feet.push_back({land.index(x, y), float(station.along / total * (values - 1)),
                            float(std::abs(off) / spacing), float(reach / spacing)});
        }
    return feet;
}

// By the nearest point of the whole curve.
std::vector<Foot> on_shadow(const Landform& landform, const Field<float>& land,
                            double spacing) {
    const geometry::Shape& shadow = landform.shadow;
    const double depth = spacing * land.height(), length = shadow.length();
    const int values = landform.silhouette.width();
    double widest = 0.0;
    for (int i = 0; i < values; ++i) {
        const auto [left, right] = landform.boundary(length * i / (values - 1));
        widest = std::max({widest, left, right});
    }
    const geometry::Grid grid{spacing, 0.0, depth, 0, 0, land.width(), land.height()};
    Field<geometry::Nearest> nearest(land.width(), land.height());
    geometry::add_nearest(shadow, grid, widest, nearest);

    std::vector<Foot> feet;
    for (int y = 0; y < land.height(); ++y)
        for (int x = 0; x < land.width(); ++x) {
            const auto [squared, segment] = nearest(x, y);
            if (segment < 0) continue;
            const auto s = std::size_t(segment);
            const Point2 p = grid.centre(x, y), &a = shadow.points[s],
                         &b = shadow.points[s + 1];
            const double share = geometry::nearest_share(a, b, p);
            const double along =
                shadow.along[s] + share * (shadow.along[s + 1] - shadow.along[s]);
            const bool left = cross(from_to(a, b), from_to(a, p)) > 0.0;
            const double reach = landform.boundary(along)[left ? 0 : 1];
            const double distance = std::sqrt(squared);
            if (!(distance < reach)) continue;
            feet.push_back({nearest.index(x, y), float(along / length * (values - 1)),
                            float(distance / spacing), float(reach / spacing)});
        }
    return feet;
}

}  // namespace

float Foot::weight(float share) const {
    const float a = distance / std::max(share * reach, float(kLeastReach));
    const float b = a * a - 1.0f;
    return a < 1.0f && distance < reach ? b * b : 0.0f;
}

bool lies_on_base_line(const geometry::Shape& shadow) {
    if (shadow.closed) return false;
    const Point2 chord =
        geometry::unit_of(from_to(shadow.points.front(), shadow.points.back()));
    for (int s = 0; s < shadow.segments(); ++s) {
        const Point2 d =
            from_to(shadow.points[std::size_t(s)], shadow.points[std::size_t(s) + 1]);
        if (dot(geometry::unit_of(d), chord) < kMostLean) return false;
    }
    return true;
}

std::vector<Foot> footprint(const Landform& landform, const Field<float>& land,
                            double spacing) {
    std::vector<Foot> feet = lies_on_base_line(landform.shadow)
                                 ? on_base_line(landform, land, spacing)
                                 : on_shadow(landform, land, spacing);
    for (Foot& foot : feet) foot.noise = foot.weight(1.0f);
    return feet;
}

void share_out(std::vector<std::vector<Foot>>& feet, std::size_t samples) {
    if (feet.size() < 2) return;
    // Weights are inverse distances, without a step where a landform ends. On a shadow
    // only its own landform counts.
    const auto pull = [](const Foot& foot) {
        return foot.noise / (foot.distance * foot.distance + 1e-3f);
    };
    std::vector<float> sum(samples);
    for (const auto& of_one : feet)
        for (const Foot& foot : of_one) sum[foot.index] += pull(foot);
    for (auto& of_one : feet)
        for (Foot& foot : of_one)
            foot.part = sum[foot.index] > 0.0f ? pull(foot) / sum[foot.index] : 0.0f;
}

}  // namespace cydonia::sketch
