#include "synth/sketch/boundary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "field/error.h"
#include "synth/sketch/bands.h"

namespace cydonia::sketch {
namespace {

constexpr double kLevel = 0.25;  // share of a shoulder's steepest slope: it levels off
constexpr double kNarrowest =
    1.0 / 16;  // least width of a shoulder, as a share of the length
constexpr int kMostPlaces = 4096;
constexpr std::size_t kMostLines = 100'000;  // of a boundary

// The number of values from the begin of a line to where it first turns or levels off.
int shoulder(const std::vector<double>& line) {
    const int n = int(line.size());
    double steepest = 0.0;
    for (int i = 1; i < n; ++i) {
        const double slope = line[std::size_t(i)] - line[std::size_t(i - 1)];
        if (std::abs(slope) > std::abs(steepest)) steepest = slope;
        if (slope * (steepest < 0.0 ? -1.0 : 1.0) < kLevel * std::abs(steepest) &&
            i > kNarrowest * n)
            return i;
    }
    return n - 1;
}

// The width of a rounded end so far from its tip, as a share of its full width: a quarter
// of an ellipse.
double round(double from, double radius) {
    const double a = std::clamp(1.0 - from / radius, 0.0, 1.0);
    return std::sqrt(1.0 - a * a);
}

using Table = std::vector<std::array<double, 2>>;

Boundary interpolated(Table table, double length) {
    const auto shared = std::make_shared<const Table>(std::move(table));
    return [shared, length](double along) {
        const double k =
            std::clamp(along / length, 0.0, 1.0) * double(shared->size() - 1);
        const auto i = std::min(std::size_t(k), shared->size() - 2);
        const auto &a = (*shared)[i], &b = (*shared)[i + 1];
        const double f = k - double(i);
        return std::array{a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])};
    };
}

// The distance from p along a direction to a curve, metres; none where it does not cross
// any.
double distance_to(const std::vector<geometry::NamedShape>& curves, const Point2& p,
                   const Point2& direction) {
    using geometry::cross;
    double nearest = HUGE_VAL;
    for (const geometry::NamedShape& curve : curves)
        for (std::size_t s = 1; s < curve.shape.points.size(); ++s) {
            const Point2 &a = curve.shape.points[s - 1], &b = curve.shape.points[s];
            const Point2 line = geometry::from_to(a, b), to = geometry::from_to(p, a);
            const double area = cross(direction, line);
            if (area == 0.0) continue;
            const double along = cross(to, line) / area,
                         share = cross(to, direction) / area;
            if (along >= 0.0 && share >= 0.0 && share <= 1.0)
                nearest = std::min(nearest, along);
        }
    return nearest;
}

// Fills the gaps of one side from their neighbours, and returns how many there were.
int bridge(Table& table, std::size_t side) {
    int gaps = 0, last = -1;
    const int n = int(table.size());
    const auto value = [&](int i) -> double& { return table[std::size_t(i)][side]; };
    for (int i = 0; i <= n; ++i) {
        if (i < n && !std::isfinite(value(i))) {
            ++gaps;
            continue;
        }
        for (int k = last + 1; k < std::min(i, n); ++k)
            value(k) = last < 0 ? value(i)
                       : i == n ? value(last)
                                : value(last) + (value(i) - value(last)) *
                                                    double(k - last) / (i - last);
        last = i;
    }
    return gaps;
}

}  // namespace

Boundary capsule(const Field<float>& silhouette, double length) {
    const int n = silhouette.width();
    // The silhouette without details narrower than an eighth of it, as shoulders are not
    // noise.
    const int levels = std::clamp(int(std::log2(n / 8.0)), 1, 10);
    const Field<float> smooth = smoothed(silhouette, levels)[0];
    std::vector<double> line(smooth.begin(), smooth.end());
    for (int i = 0; i < n; ++i)  // above the line through its ends
        line[std::size_t(i)] -=
            smooth[0] + (smooth[std::size_t(n - 1)] - smooth[0]) * double(i) / (n - 1);
    std::vector<double> back(line.rbegin(), line.rend());
    const double left = length * shoulder(line) / (n - 1),
                 right = length * shoulder(back) / (n - 1);
    // The shoulders of a single peak make up all of it.
    const double fit = std::min(1.0, length / (left + right));
    const double begin = fit * left, end = fit * right, width = 0.5 * (begin + end);
    Table table;
    const int places = std::max(n, 64);
    for (int i = 0; i < places; ++i) {
        const double along = length * i / (places - 1);
        const double w =
            width * std::min(round(along, begin), round(length - along, end));
        table.push_back({w, w});
    }
    return interpolated(std::move(table), length);
}

Boundary rounded(Boundary boundary, double length, const std::array<bool, 2>& goes_on) {
    return [boundary = std::move(boundary), length, goes_on](double along) {
        std::array<double, 2> sides = boundary(along);
        for (double& side : sides) {
            const double radius = std::min(side, 0.5 * length);
            if (!goes_on[0]) side *= round(along, radius);
            if (!goes_on[1]) side *= round(length - along, radius);
        }
        return sides;
    };
}

Boundary drawn_boundary(const geometry::Shape& shadow,
                        const std::vector<geometry::NamedShape>& curves, double spacing,
                        const std::string& name, Progress& progress) {
    std::size_t lines = 0;
    for (const geometry::NamedShape& curve : curves) lines += curve.shape.points.size();
    if (lines > kMostLines)
        throw bad_request("'{}': its boundary has more than {} points", name, kMostLines);
    const int count =
        std::clamp(int(std::ceil(shadow.length() / spacing)), 8, kMostPlaces);
    Table table;
    int crossed = 0;
    for (int i = 0; i <= count; ++i) {
        // Not at the very ends, where the sides are undefined.
        const double along =
            shadow.length() * std::clamp(double(i), 0.25, count - 0.25) / count;
        const double half = 0.5 * shadow.length() / count;
        const Point2 p = shadow.at(along);
        const Point2 d = geometry::unit_of(
            geometry::from_to(shadow.at(std::max(0.0, along - half)),
                              shadow.at(std::min(shadow.length(), along + half))));
        std::array<double, 2> sides{distance_to(curves, p, {-d[1], d[0]}),
                                    distance_to(curves, p, {d[1], -d[0]})};
        for (double& side : sides)
            if (side < spacing) side = HUGE_VAL, ++crossed;
        table.push_back(sides);
    }
    if (crossed > 0)
        progress.note(fmt::format(
            "'{}': its boundary crosses its way; it is led past it there", name));
    for (const std::size_t side : {0u, 1u}) {
        const auto missing = std::ranges::count_if(
            table, [&](const auto& sides) { return !std::isfinite(sides[side]); });
        const std::string_view where = side == 0 ? "left" : "right";
        if (2 * std::size_t(missing) > table.size())
            throw bad_request(
                "'{}': its boundary does not surround it: nothing is drawn {} of most of "
                "its way (it runs from its first point to its last)",
                name, where);
        if (bridge(table, side) > crossed)
            progress.note(fmt::format(
                "'{}': its boundary has a gap to the {}, which is bridged", name, where));
    }
    return interpolated(std::move(table), shadow.length());
}

}  // namespace cydonia::sketch
