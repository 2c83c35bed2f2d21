#include "render/embree/diagram.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "field/parallel.h"
#include "field/random.h"
#include "field/rgb.h"
#include "render/passes/view.h"

namespace cydonia::render {
namespace {

using Points = Field<SeenPoint>;

constexpr Rgb kHeights[] = {{0.12f, 0.06f, 0.02f}, {0.08f, 0.25f, 0.05f},
                            {0.50f, 0.06f, 0.03f}, {0.75f, 0.25f, 0.03f},
                            {0.80f, 0.65f, 0.08f}, {0.85f, 0.85f, 0.85f}};
constexpr Rgb kSlopes[] = {{0.35f, 0.35f, 0.35f},
                           {0.08f, 0.30f, 0.06f},
                           {0.55f, 0.06f, 0.04f},
                           {0.80f, 0.65f, 0.06f}};
constexpr double kSteepest = 60.0;           // degrees, shown in the last of kSlopes
constexpr Rgb kAround{0.25f, 0.25f, 0.25f};  // what is not land
constexpr Rgb kPaper{0.90f, 0.88f, 0.82f};   // the background of ink and contours
constexpr Rgb kInk{0.015f, 0.015f, 0.02f};
constexpr Rgb kWater{0.05f, 0.15f, 0.35f};
constexpr Rgb kContourLine{0.22f, 0.09f, 0.03f};
constexpr Rgb kGridLine{0.05f, 0.14f, 0.35f};

// A colour between evenly spaced ones; `at` runs from 0 (first) to 1 (last).
Rgb of_palette(std::span<const Rgb> colours, double at) {
    const auto last = static_cast<double>(colours.size() - 1);
    const double x = std::clamp(at, 0.0, 1.0) * last;
    const auto i = std::min(static_cast<std::size_t>(x), colours.size() - 2);
    return mixed(colours[i], colours[i + 1], x - static_cast<double>(i));
}

bool is_land(const SeenPoint& p) {
    return p.surface == Surface::kLand || p.surface == Surface::kSide;
}

// The neighbours before and after a pixel in the direction (dx, dy). A neighbour that is
// outside the frame, of another surface or behind a crest is replaced by the pixel
// itself.
struct Beside {
    const SeenPoint &before, &after;
    double apart;  // pixels
};
Beside beside(const Points& points, int x, int y, int dx, int dy) {
    const SeenPoint& p = points(x, y);
    const auto at = [&](int i, int j) -> const SeenPoint& {
        if (!points.contains(i, j)) return p;
        const SeenPoint& q = points(i, j);
        const bool joined =
            q.surface == p.surface && std::abs(q.depth - p.depth) < 0.04f * p.depth;
        return joined ? q : p;
    };
    const SeenPoint &before = at(x - dx, y - dy), &after = at(x + dx, y + dy);
    const int sides = (&before != &p) + (&after != &p);
    return {before, after, double(sides * (std::abs(dx) + std::abs(dy)))};
}

// The share of a pixel that is covered by lines, `wide` pixels wide, where a value is a
// multiple of `interval`. Lines fade out where they are too close to be told apart.
template <class Value>
double line(const Points& points, int x, int y, double interval, double wide,
            const Value& value) {
    const auto slope = [&](int dx, int dy) {
        const Beside b = beside(points, x, y, dx, dy);
        return b.apart > 0.0 ? (value(b.after) - value(b.before)) / b.apart : 0.0;
    };
    const double gradient = std::hypot(slope(1, 0), slope(0, 1));
    if (gradient <= 0.0) return 0.0;
    const double v = value(points(x, y));
    const double away = std::abs(v - interval * std::round(v / interval)) / gradient;
    const double apart = interval / gradient;
    return std::clamp(0.5 * wide + 0.5 - away, 0.0, 1.0) *
           std::clamp(0.5 * (apart - 2.0 * wide), 0.0, 1.0);
}

class Diagram {
  public:
    Diagram(const Shot& shot, const Terrain& terrain, Style style)
        : style_(style),
          view_(terrain, {.flood = shot.options.water}),
          rays_(shot.camera),
          axes_(shot.camera),
          to_sun_(direction_to(shot.sun)),
          points_(view_.seen(rays_, shot.smooth)) {
        const auto [low, high] = std::ranges::minmax(view_.terrain().heights);
        low_ = low, high_ = std::max(high, low + 1.0f);
        contours_ = contour_interval(view_.terrain());
        grid_ = grid_interval(view_.terrain());
    }

    Field<Rgb> drawn() const {
        Field<Rgb> frame(points_.width(), points_.height());
        parallel_for(frame.height(), 4, [&](int y) {
            for (int x = 0; x < frame.width(); ++x) frame(x, y) = colour(x, y);
        });
        if (style_ == Style::kInk) draw_ink(frame);
        return frame;
    }

  private:
    Rgb colour(int x, int y) const {
        const SeenPoint& p = points_(x, y);
        const bool on_paper = style_ == Style::kInk || style_ == Style::kContours;
        if (p.surface == Surface::kSky || p.surface == Surface::kOutskirts)
            return on_paper ? kPaper : kAround;
        const Vec3 normal = vec3_of(p.normal);
        const double lit = std::max(0.0, dot(normal, to_sun_));
        const double shade = 0.25 + 0.75 * lit;
        const bool wet = p.surface == Surface::kWater;
        switch (style_) {
            case Style::kHeight:
                if (wet) break;
                return shade * of_palette(kHeights, (p.at[2] - low_) / (high_ - low_));
            case Style::kSlope: {
                if (wet) break;
                const double slope = std::acos(std::clamp(normal.z, -1.0, 1.0));
                return shade * of_palette(kSlopes, slope / radians(kSteepest));
            }
            case Style::kInk:
                return wet ? mixed(kPaper, kWater, 0.2) : kPaper;
            case Style::kContours:
                return contoured(x, y, wet ? mixed(kPaper, kWater, 0.4) : kPaper);
            case Style::kRadiance:
                return scaled_by_curvature(x, y, 0.08 + 0.84 * lit) *
                       Rgb{0.8f, 0.8f, 0.8f};
            case Style::kGrey:
            case Style::kNatural:
                return shade * Rgb{0.7f, 0.7f, 0.7f};
        }
        return shade * kWater;
    }

    // Shaded as a relief map, with every fifth contour line stronger.
    Rgb contoured(int x, int y, const Rgb& paper) const {
        const SeenPoint& p = points_(x, y);
        const double lit = std::max(0.0, dot(vec3_of(p.normal), to_sun_));
        const double level = std::max(0.1, to_sun_.z);
        Rgb colour = std::clamp(0.45 + 0.55 * lit / level, 0.0, 1.1) * paper;
        if (!is_land(p)) return colour;
        const auto east = [](const SeenPoint& q) { return double(q.at[0]); };
        const auto north = [](const SeenPoint& q) { return double(q.at[1]); };
        const auto height = [](const SeenPoint& q) { return double(q.at[2]); };
        const double squares = std::max(line(points_, x, y, grid_, 1.0, east),
                                        line(points_, x, y, grid_, 1.0, north));
        colour = mixed(colour, kGridLine, 0.55 * squares);
        colour = mixed(colour, kContourLine,
                       0.6 * line(points_, x, y, contours_, 1.0, height));
        return mixed(colour, kContourLine,
                     0.9 * line(points_, x, y, 5.0 * contours_, 1.6, height));
    }

    // R. Vergne, R. Pacanowski, P. Barla, X. Granier, C. Schlick, "Radiance Scaling for
    // Versatile Surface Enhancement" (2010), eq. 4: light times a function of it and of
    // the curvature that the frame shows, unchanged at `kMiddle` and where it is even.
    double scaled_by_curvature(int x, int y, double light) const {
        constexpr double kMiddle = 0.45, kStrength = 1.8;
        double curvature = 0.0;
        for (const int step : {1, 3}) {
            const Beside h = beside(points_, x, y, step, 0),
                         v = beside(points_, x, y, 0, step);
            const Vec3 across = vec3_of(h.after.normal) - vec3_of(h.before.normal);
            const Vec3 down = vec3_of(v.after.normal) - vec3_of(v.before.normal);
            curvature += dot(across, axes_.right) - dot(down, axes_.up);
        }
        const double e = std::exp(kStrength * std::tanh(1.2 * curvature));
        const double a = kMiddle, d = light;
        return light * (a * e + d * (1.0 - a * (1.0 + e))) /
               (a + d * (e - a * (1.0 + e)));
    }

    // Strokes run down the slope, and along edges where the ground is seen at a low angle
    // (Brosz 2007, section 6). There are more where it is darker or the angle is lower.
    void draw_ink(Field<Rgb>& frame) const {
        constexpr int kApart = 4;  // pixels
        Field<float> ink(frame.width(), frame.height());
        for (int y0 = 0; y0 < frame.height(); y0 += kApart)
            for (int x0 = 0; x0 < frame.width(); x0 += kApart) {
                std::uint64_t h =
                    hash_of({key("ink"), std::uint64_t(x0), std::uint64_t(y0)});
                const auto draw = [&] { return unit(h = mix(h)); };
                const int x = x0 + int(kApart * draw()), y = y0 + int(kApart * draw());
                if (!points_.contains(x, y)) continue;
                const SeenPoint& p = points_(x, y);
                if (p.surface != Surface::kLand) continue;
                const Vec3 n = vec3_of(p.normal);
                const Vec3 look = rays_.through(x + 0.5, y + 0.5).direction;
                const double facing = std::abs(dot(n, look));
                const double dark = 1.0 - std::max(0.0, dot(n, to_sun_));
                const double steep = 1.0 - n.z;
                const double edge = std::max(0.0, 1.0 - facing / 0.3);
                const double tone = std::clamp(
                    1.3 * dark * dark * std::min(1.0, 6.0 * steep) + 0.8 * edge, 0.0,
                    1.0);
                const double length = 5.0 + 7.0 * draw();
                if (draw() >= tone) continue;
                const Vec3 way = edge > 0.3 ? cross(n, look)
                                            : Vec3{n.x * n.z, n.y * n.z, n.z * n.z - 1.0};
                stroke(ink, x, y, way, length, float(0.45 + 0.45 * tone));
            }
        for (int y = 1; y + 1 < frame.height(); ++y)
            for (int x = 1; x + 1 < frame.width(); ++x)
                if (is_edge(x, y)) ink(x, y) = std::max(ink(x, y), 0.85f);
        for (std::size_t i = 0; i < frame.size(); ++i)
            frame[i] = mixed(frame[i], kInk, ink[i]);
    }

    // Whether a nearer surface ends here before a farther one.
    bool is_edge(int x, int y) const {
        const SeenPoint& p = points_(x, y);
        if (!is_land(p)) return false;
        const auto behind = [&](int i, int j) {
            const SeenPoint& q = points_(i, j);
            return !is_land(q)
                       ? q.surface == Surface::kSky || q.surface == Surface::kOutskirts
                       : q.depth > 1.06f * p.depth;
        };
        return behind(x, y - 1) || behind(x - 1, y) || behind(x + 1, y);
    }

    void stroke(Field<float>& ink, int x, int y, const Vec3& way, double length,
                float strength) const {
        const SeenPoint& p = points_(x, y);
        const auto from = rays_.project(vec3_of(p.at));
        const double step = 1e-3 * std::max(1.0, double(p.depth));
        const auto to = rays_.project(vec3_of(p.at) + step * way);
        const double far = std::hypot(to.x - from.x, to.y - from.y);
        if (far < 1e-9) return;
        const double dx = (to.x - from.x) / far, dy = (to.y - from.y) / far;
        const int reach = int(length / 2.0) + 2;
        for (int j = y - reach; j <= y + reach; ++j)
            for (int i = x - reach; i <= x + reach; ++i) {
                if (!points_.contains(i, j)) continue;
                const SeenPoint& q = points_(i, j);
                if (q.surface != p.surface ||
                    std::abs(q.depth - p.depth) > 0.03f * p.depth)
                    continue;
                const double along = (i - x) * dx + (j - y) * dy;
                const double aside = std::abs((i - x) * dy - (j - y) * dx);
                const double beyond = std::max(0.0, std::abs(along) - 0.5 * length);
                const double cover =
                    std::clamp(1.05 - std::hypot(aside, beyond), 0.0, 1.0);
                ink(i, j) = std::max(ink(i, j), strength * float(cover));
            }
    }

    Style style_;
    View view_;
    CameraRays rays_;
    CameraAxes axes_;
    Vec3 to_sun_;
    Points points_;
    float low_ = 0.0f, high_ = 1.0f;
    double contours_ = 1.0, grid_ = 1.0;
};

}  // namespace

double round_interval(double least) {
    const double ten = std::pow(10.0, std::floor(std::log10(least)));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * ten >= least * (1.0 - 1e-9)) return times * ten;
    return 10.0 * ten;
}

double contour_interval(const Terrain& terrain) {
    const auto [low, high] = std::ranges::minmax(terrain.heights);
    return round_interval(std::max(1e-3, (static_cast<double>(high) - low) / 25.0));
}

double grid_interval(const Terrain& terrain) {
    return round_interval(std::max(terrain.width(), terrain.depth()) / 12.0);
}

Field<Rgb8> diagram(const Shot& shot, const Terrain& terrain, Style style) {
    const Field<Rgb> drawn = Diagram(shot, terrain, style).drawn();
    Field<Rgb8> shown(drawn.width(), drawn.height());
    parallel_for(drawn.height(), 16, [&](int y) {
        for (int x = 0; x < drawn.width(); ++x)
            for (std::size_t c = 0; c < 3; ++c)
                shown(x, y)[c] = srgb_level(drawn(x, y)[c]);
    });
    return shown;
}

}  // namespace cydonia::render
