#include "synth/sketch/stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "field/error.h"
#include "synth/geometry/plane.h"

namespace cydonia::sketch {
namespace {

constexpr double kTolerance = 1e-4;  // share of the page
constexpr double kFold = 1.0 / 512;  // share of the width that a steady hand may go back
constexpr std::size_t kMostCrossed = 20000;  // points of a way that is checked for loops

// Where the lines a-b and c-d cross, if they do.
std::optional<Point2> crossing(const Point2& a, const Point2& b, const Point2& c,
                               const Point2& d) {
    const Point2 u = geometry::from_to(a, b), v = geometry::from_to(c, d);
    const double area = geometry::cross(u, v);
    if (area == 0.0) return {};
    const Point2 w = geometry::from_to(a, c);
    const double s = geometry::cross(w, v) / area, t = geometry::cross(w, u) / area;
    if (!(s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)) return {};
    return geometry::between(a, b, s);
}

double length_of(const std::vector<Point2>& way, std::size_t from, std::size_t to) {
    double length = 0.0;
    for (std::size_t i = from; i < to; ++i)
        length += geometry::distance(way[i], way[i + 1]);
    return length;
}

}  // namespace

Line line_of(const std::vector<std::vector<Point2>>& strokes, int values) {
    Line line{HUGE_VAL, -HUGE_VAL, {}, false};
    for (const auto& stroke : strokes)
        for (const Point2& p : stroke)
            line.left = std::min(line.left, p[0]),
            line.right = std::max(line.right, p[0]);
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    Field<float>& heights = line.values = Field<float>(values, 1, kNone);
    const auto place = [&](const Point2& p) {
        return (p[0] - line.left) / (line.right - line.left) * (values - 1);
    };
    for (const auto& stroke : strokes) {
        double furthest = -HUGE_VAL;
        for (std::size_t i = 1; i < stroke.size(); ++i) {
            const Point2 &a = stroke[i - 1], &b = stroke[i];
            const double from = place(a), to = place(b);
            furthest = std::max(furthest, from);
            line.folds |= to < furthest - std::max(1.0, kFold * (values - 1));
            const auto [low, high] = std::minmax(from, to);
            for (int k = int(std::ceil(low - 1e-9)); k <= high + 1e-9; ++k) {
                const double t = to == from ? 1.0 : (k - from) / (to - from);
                heights[std::size_t(std::clamp(k, 0, values - 1))] =
                    float(a[1] + std::clamp(t, 0.0, 1.0) * (b[1] - a[1]));
            }
        }
    }
    // Interpolates values without a stroke between their neighbours.
    int last = -1;
    for (int k = 0; k < values; ++k) {
        if (std::isnan(heights[std::size_t(k)])) continue;
        for (int gap = last + 1; gap < k; ++gap) {
            const float before = heights[std::size_t(std::max(last, 0))],
                        after = heights[std::size_t(k)];
            const float t = last < 0 ? 1.0f : float(gap - last) / float(k - last);
            heights[std::size_t(gap)] = last < 0 ? after : before + t * (after - before);
        }
        last = k;
    }
    for (int k = last + 1; k < values; ++k)
        heights[std::size_t(k)] = heights[std::size_t(last)];
    return line;
}

std::vector<SvgPath> strokes_of(const Source& drawing, const std::string& id,
                                const std::string& name) {
    std::vector<SvgPath> paths = svg_paths(drawing, kTolerance);
    if (!id.empty())
        std::erase_if(paths, [&](const SvgPath& path) { return !path.is_called(id); });
    if (paths.empty())
        throw bad_request("{}: '{}': {}", drawing.name(), name,
                          id.empty()
                              ? "nothing is drawn"
                              : fmt::format("no path or layer is called '{}'", id));
    return paths;
}

Field<float> heights_of(const Silhouette& silhouette, int values, const std::string& name,
                        Progress& progress) {
    std::vector<std::vector<Point2>> strokes;
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (SvgPath& path : strokes_of(silhouette.drawing, silhouette.id, name)) {
        for (Point2& p : path.points) {
            left = std::min(left, p[0]), right = std::max(right, p[0]);
            p[1] =
                silhouette.bottom + (1.0 - p[1]) * (silhouette.top - silhouette.bottom);
        }
        strokes.push_back(std::move(path.points));
    }
    if (!(right - left > 1e-6))
        throw bad_request("{}: '{}': the silhouette is upright and has no width",
                          silhouette.drawing.name(), name);
    Line line = line_of(strokes, values);
    if (line.folds)
        progress.note(fmt::format(
            "'{}': its silhouette folds back; what is drawn last counts there", name));
    return std::move(line.values);
}

int cut_loops(std::vector<Point2>& way) {
    int loops = 0;
    const bool closed = way.size() > 2 && way.front() == way.back();
    if (way.size() > kMostCrossed) return 0;
    for (std::size_t i = 0; i + 2 < way.size(); ++i)
        // From the end, so that the widest of several loops at one position is cut off
        // first.
        for (std::size_t j = way.size() - 2; j > i + 1; --j) {
            const auto at = crossing(way[i], way[i + 1], way[j], way[j + 1]);
            if (!at) continue;
            ++loops;
            const double inner = length_of(way, i + 1, j);
            if (closed && inner > 0.5 * length_of(way, 0, way.size() - 1)) {
                std::vector<Point2> ring{*at};
                ring.insert(ring.end(), way.begin() + std::ptrdiff_t(i) + 1,
                            way.begin() + std::ptrdiff_t(j) + 1);
                ring.push_back(*at);
                way = std::move(ring);
                return loops + cut_loops(way);
            }
            way.erase(way.begin() + std::ptrdiff_t(i) + 1,
                      way.begin() + std::ptrdiff_t(j) + 1);
            way.insert(way.begin() + std::ptrdiff_t(i) + 1, *at);
            break;
        }
    return loops;
}

}  // namespace cydonia::sketch
