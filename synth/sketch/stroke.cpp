#include "synth/sketch/stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "field/error.h"
#include "field/svg_paths.h"

namespace cydonia::sketch {
namespace {

constexpr double kTolerance = 1e-4;  // of the page

std::vector<SvgPath> paths_of(const Silhouette& silhouette, const std::string& name) {
    std::vector<SvgPath> paths = svg_paths(silhouette.drawing, kTolerance);
    if (!silhouette.id.empty())
        std::erase_if(paths,
                      [&](const SvgPath& path) { return path.id != silhouette.id; });
    if (paths.empty())
        throw bad_request("{}: '{}': {}", silhouette.drawing.name(), name,
                          silhouette.id.empty()
                              ? "nothing is drawn"
                              : fmt::format("no path has the id '{}'", silhouette.id));
    return paths;
}

}  // namespace

Field<float> heights_of(const Silhouette& silhouette, int values, const std::string& name,
                        Progress& progress) {
    const std::vector<SvgPath> paths = paths_of(silhouette, name);
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (const SvgPath& path : paths)
        for (const Point2& p : path.points)
            left = std::min(left, p[0]), right = std::max(right, p[0]);
    if (!(right - left > 1e-6))
        throw bad_request("{}: '{}': the silhouette is upright and has no width",
                          silhouette.drawing.name(), name);

    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    Field<float> heights(values, 1, kNone);
    bool folds = false;
    for (const SvgPath& path : paths)
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const auto place = [&](const Point2& p) {
                return (p[0] - left) / (right - left) * (values - 1);
            };
            const auto metres = [&](const Point2& p) {
                return silhouette.bottom +
                       (1.0 - p[1]) * (silhouette.top - silhouette.bottom);
            };
            const Point2 &a = path.points[i - 1], &b = path.points[i];
            const double from = place(a), to = place(b);
            folds |= to < from - 1.0;
            const auto [low, high] = std::minmax(from, to);
            for (int k = int(std::ceil(low - 1e-9)); k <= high + 1e-9; ++k) {
                const double t = to == from ? 1.0 : (k - from) / (to - from);
                heights[std::size_t(std::clamp(k, 0, values - 1))] =
                    float(metres(a) + std::clamp(t, 0.0, 1.0) * (metres(b) - metres(a)));
            }
        }
    if (folds)
        progress.note(fmt::format(
            "'{}': its silhouette folds back; what is drawn last counts there", name));
    // What no stroke is over: between its neighbours.
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
    return heights;
}

}  // namespace cydonia::sketch
