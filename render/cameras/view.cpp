#include "render/cameras/view.h"

#include <cmath>
#include <limits>

#include "field/border.h"

namespace cydonia::render {
namespace {

// The part of a ray that may hit the land, as distances along it.
struct Span {
    double from = 0.0, to = std::numeric_limits<double>::infinity();

    void cut(double start, double step, double low, double high) {
        if (std::abs(step) < 1e-12) {
            if (start < low || start > high) to = -1.0;
            return;
        }
        const double a = (low - start) / step, b = (high - start) / step;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
};

Span within(const Terrain& t, const Vec3& start, const Vec3& step) {
    const auto [lowest, highest] = std::ranges::minmax(t.heights);
    Span span;
    span.cut(start.x, step.x, 0.0, t.width());
    span.cut(start.y, step.y, 0.0, t.depth());
    span.cut(start.z, step.z, lowest - 1.0, highest + 1.0);
    return span;
}

}  // namespace

Terrain surface_of(const Terrain& terrain, const std::optional<WaterOptions>& flood) {
    Terrain surface;
    surface.heights = terrain.heights;
    surface.spacing = terrain.spacing;
    for (std::size_t i = 0; i < surface.heights.size(); ++i)
        surface.heights[i] += water_depth(terrain, i);
    if (flood) {
        const auto level = static_cast<float>(flood->level.in(terrain.width()));
        for (float& height : surface.heights) height = std::max(height, level);
    }
    return surface;
}

double ground_at(const Terrain& t, double east, double north) {
    const Field<float>& h = t.heights;
    const double x = std::clamp(east / t.spacing - 0.5, 0.0, h.width() - 1.0);
    const double y =
        std::clamp(h.height() - north / t.spacing - 0.5, 0.0, h.height() - 1.0);
    const int i = std::min(static_cast<int>(x), std::max(0, h.width() - 2));
    const int j = std::min(static_cast<int>(y), std::max(0, h.height() - 2));
    const int i1 = std::min(i + 1, h.width() - 1), j1 = std::min(j + 1, h.height() - 1);
    // Squares are split from north-west to south-east, as they are drawn.
    const double u = x - i, v = y - j, nw = h(i, j), se = h(i1, j1);
    return u > v ? nw + u * (h(i1, j) - nw) + v * (se - h(i1, j))
                 : nw + v * (h(i, j1) - nw) + u * (se - h(i, j1));
}

bool over_land(const Terrain& t, const Vec3& p) {
    return p.x >= 0.0 && p.y >= 0.0 && p.x <= t.width() && p.y <= t.depth();
}

namespace {

bool meets_sea(const Terrain& t) {
    bool wet = false;
    on_border(t.heights, [&](int x, int y) {
        wet = wet || water_depth(t, t.heights.index(x, y)) > 0.0f;
    });
    return wet;
}

// Whether more of the border is under the flood than above it: then the land is an
// island.
bool is_surrounded(const Terrain& t, const std::optional<WaterOptions>& flood) {
    if (!flood) return false;
    const double level = flood->level.in(t.width());
    int wet = 0, all = 0;
    on_border(t.heights, [&](int x, int y) {
        wet += t.heights(x, y) < level;
        ++all;
    });
    return 2 * wet > all;
}

}  // namespace

Around around_of(const Terrain& t, const Options& options) {
    if (options.ground.around) return *options.ground.around;
    const bool alone =
        !t.shadows.empty() || meets_sea(t) || is_surrounded(t, options.water);
    return alone ? Around::kLevel : Around::kLand;
}

double outskirts_height(const Terrain& t) { return lowest_on_border(t.heights); }

double pixel_size(const Camera& c) {
    return pixel_side(c) * (c.projection == Camera::Projection::kOrthographic
                                ? 1.0
                                : length(c.target - c.eye));
}

bool is_smooth(const Camera& c, const Terrain& terrain) {
    constexpr double kSmall = 4.0;  // pixels
    if (c.projection == Camera::Projection::kOrthographic) return false;
    // In most frames the nearest ground is a few times as far away as the eye is high.
    const double high = c.eye.z - ground_at(terrain, c.eye.x, c.eye.y);
    const double nearest = std::min(length(c.target - c.eye), 3.0 * std::max(high, 0.0));
    return terrain.spacing > kSmall * pixel_side(c) * nearest;
}

double aspect(const Camera& c) { return static_cast<double>(c.width) / c.height; }

Vec3 seen(const Camera& c, const Vec3& p) { return CameraAxes(c)(p); }

bool in_frame(const Camera& c, const Vec3& p) {
    const Vec3 s = seen(c, p);
    const double half = std::tan(0.5 * c.field_of_view) * s.z;
    return s.z > 0.0 && std::abs(s.x) <= half && std::abs(s.y) <= half / aspect(c);
}

std::optional<Vec3> where_it_meets(const Terrain& t, const Vec3& from,
                                   const Vec3& direction) {
    const auto above = [&](double along) {
        const Vec3 p = from + along * direction;
        return p.z - ground_at(t, p.x, p.y);
    };
    const Span span = within(t, from, direction);
    for (double along = span.from; along < span.to; along += 0.5 * t.spacing) {
        double low = along, high = std::min(along + 0.5 * t.spacing, span.to);
        if (above(high) > 0.0) continue;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (above(middle) > 0.0 ? low : high) = middle;
        }
        return from + high * direction;
    }
    return std::nullopt;
}

}  // namespace cydonia::render
