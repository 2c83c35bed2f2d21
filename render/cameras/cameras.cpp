#include "render/cameras/cameras.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "field/error.h"
#include "field/svg_camera.h"
#include "render/cameras/checks.h"
#include "render/cameras/path.h"
#include "render/cameras/view.h"

namespace cydonia::render {
namespace {

constexpr int kSmallest = 16;         // pixels
constexpr double kSkyMargin = 0.22;   // sky above the skyline, over the frame's height
const double kSteep = radians(60.0);  // an oblique view from above this has no skyline

int scaled(int pixels, Quality quality) {
    const int thirds = 1 + static_cast<int>(quality);
    return std::max(kSmallest, (pixels * thirds + 1) / 3);
}

// Half of the vertical field of view.
double half_height(const Camera& c) {
    return std::atan(std::tan(0.5 * c.field_of_view) / aspect(c));
}

double mean_height(const Terrain& t) {
    double sum = 0.0;
    for (const float h : t.heights) sum += h;
    return sum / static_cast<double>(t.heights.size());
}

Vec3 centre(const Terrain& t) {
    return {0.5 * t.width(), 0.5 * t.depth(), mean_height(t)};
}

// A camera that looks straight up or down has north at the top of its frame.
void level(Camera& c) {
    const Vec3 d = normalized(c.target - c.eye);
    if (std::hypot(d.x, d.y) < 1e-6) c.up = {0.0, 1.0, 0.0};
}

Camera overhead(Camera c, const Terrain& t) {
    const auto [lowest, highest] = std::ranges::minmax(t.heights);
    c.projection = Camera::Projection::kOrthographic;
    c.target = {0.5 * t.width(), 0.5 * t.depth(), lowest};
    c.eye = {c.target.x, c.target.y, highest + std::max(t.width(), t.depth())};
    c.up = {0.0, 1.0, 0.0};
    // The frame ends with the mesh, at the centres of the outer cells, so that nothing
    // around it shows.
    c.frame_width = std::max(t.width() - t.spacing, (t.depth() - t.spacing) * aspect(c));
    return c;
}

// A camera at `distance` from the centre of the land, looking at it.
Camera around(Camera c, const CameraOptions& o, const Terrain& t, double distance) {
    c.target = centre(t);
    c.eye = c.target + distance * direction_to({o.azimuth, o.elevation});
    level(c);
    return c;
}

// Whether the far half of the land's outline lies between the frame's sides. The sides
// cut the near half, so that the land fills the frame.
bool far_side_fits(const Camera& c, const Terrain& t) {
    const Vec3 middle = centre(t);
    const double half_depth = seen(c, middle).z;
    for (const double x : {0.0, t.width()})
        for (const double y : {0.0, t.depth()}) {
            const Vec3 s = seen(c, {x, y, middle.z});
            const bool far = s.z >= half_depth * (1.0 - 1e-9);
            if (far && std::abs(s.x) > std::tan(0.5 * c.field_of_view) * s.z)
                return false;
        }
    return true;
}

// Tilts the camera until the highest skyline is kSkyMargin below the frame's top.
void aim(Camera& c, const Terrain& t) {
    const CameraAxes axes(c);
    const double side = std::tan(0.5 * c.field_of_view);
    const Vec3 ahead{c.target.x - c.eye.x, c.target.y - c.eye.y, 0.0};
    const Vec3 forward = normalized(ahead);
    double skyline = -std::numeric_limits<double>::infinity();  // rise over run
    look_over(t, [&](const Vec3& p) {
        const Vec3 s = axes(p);
        const double run = dot(p - c.eye, forward);
        if (run > 0.0 && std::abs(s.x) <= side * s.z)
            skyline = std::max(skyline, (p.z - c.eye.z) / run);
    });
    const double down = half_height(c) * (1.0 - 2.0 * kSkyMargin) - std::atan(skyline);
    if (std::abs(down) > radians(80.0)) return;
    c.target = c.eye + ahead + Vec3{0.0, 0.0, -length(ahead) * std::tan(down)};
}

// Whether the near border of the land is in the frame.
bool near_edge_shows(const Camera& c, const Terrain& t) {
    const CameraAxes axes(c);
    const double half_depth = axes(centre(t)).z;
    const int w = t.heights.width(), h = t.heights.height();
    const auto shows = [&](int x, int y) {
        const Vec3 p{t.spacing * (x + 0.5), t.spacing * (h - y - 0.5), t.heights(x, y)};
        return axes(p).z < half_depth && in_frame(c, p);
    };
    for (int x = 0; x < w; ++x)
        if (shows(x, 0) || shows(x, h - 1)) return true;
    for (int y = 0; y < h; ++y)
        if (shows(0, y) || shows(w - 1, y)) return true;
    return false;
}

// The largest distance below `too_far` at which `pleases` holds.
template <class Pleases>
double farthest(double too_far, const Pleases& pleases) {
    double near = 0.0;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (near + too_far);
        (pleases(middle) ? near : too_far) = middle;
    }
    return near;
}

// The largest distance at which the far side of the land still fills the frame and the
// near edge stays out of it.
Camera oblique(const Camera& c, const CameraOptions& o, const Terrain& t) {
    // The land's diagonal is longer than any side seen, so the answer lies below.
    const double too_far =
        2.0 * std::hypot(t.width(), t.depth()) / std::tan(0.5 * c.field_of_view);
    const double whole = farthest(
        too_far, [&](double d) { return !far_side_fits(around(c, o, t, d), t); });
    if (o.elevation >= kSteep) return around(c, o, t, whole);
    const auto aimed = [&](double distance) {
        Camera placed = around(c, o, t, distance);
        aim(placed, t);
        return placed;
    };
    return aimed(
        farthest(whole, [&](double d) { return !near_edge_shows(aimed(d), t); }));
}

// Whether the circle around the land is in the frame; then the land is, from every side.
bool circle_fits(const Camera& c, const Terrain& t) {
    constexpr int kPoints = 32;
    const double radius = 0.5 * std::hypot(t.width(), t.depth());
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        if (!in_frame(c, centre(t) + radius * direction_to({angle, 0.0}))) return false;
    }
    return true;
}

Camera orbit(const Camera& c, const CameraOptions& o, const Terrain& t) {
    if (o.distance) return around(c, o, t, o.distance->in(t.width()));
    const double radius = 0.5 * std::hypot(t.width(), t.depth());
    double whole = radius / std::sin(0.5 * c.field_of_view);
    while (!circle_fits(around(c, o, t, whole), t)) whole *= 1.02;
    return around(c, o, t, whole);
}

Vec3 above_ground(const std::array<Length, 3>& p, const Terrain& t) {
    const double east = p[0].in(t.width()), north = p[1].in(t.width());
    return {east, north, ground_at(t, east, north) + p[2].in(t.width())};
}

Camera look_at(Camera c, const CameraOptions& o, const Terrain& t) {
    c.eye = above_ground(o.eye, t);
    c.target = above_ground(o.target, t);
    return c;
}

// A camera at eye height on the ground, looking in a direction or at a target.
Camera stand(Camera c, const CameraOptions& o, const Terrain& t) {
    c.eye = above_ground({o.position[0], o.position[1], o.eye_height}, t);
    const Vec3 ahead = direction_to({o.heading, o.pitch});
    if (o.looks_at_target)
        c.target = above_ground(o.target, t);
    else if (const auto met = where_it_meets(t, c.eye, ahead))
        c.target = *met;
    else
        c.target = c.eye + std::hypot(t.width(), t.depth()) * ahead;
    return c;
}

TimedCurve curve_of(const CameraOptions& o, const Terrain& t,
                    std::array<Length, 3> CameraKey::*point) {
    std::vector<double> frames;
    std::vector<Vec3> points;
    for (const CameraKey& key : o.keys) {
        frames.push_back(key.frame);
        points.push_back(above_ground(key.*point, t));
    }
    return {std::move(frames), points, o.eased};
}

Camera on_path(Camera c, const CameraOptions& o, const Terrain& t) {
    check_keys(o);
    const TimedCurve eye = curve_of(o, t, &CameraKey::eye);
    const TimedCurve target = curve_of(o, t, &CameraKey::target);
    check_path(o, eye, target, t);
    c.eye = eye(o.frame);
    c.target = target(o.frame);
    return c;
}

// Turns the camera together with its target about the land, so that the land seems to
// turn.
void turn(Camera& c, const CameraOptions& o, const Terrain& t) {
    if (o.turn == 0.0) return;
    const Vec3 pivot = o.kind == CameraOptions::Kind::kLookAt ? c.target : centre(t);
    const double cosine = std::cos(o.turn), sine = std::sin(o.turn);
    for (Vec3* point : {&c.eye, &c.target}) {
        const Vec3 from = *point - pivot;
        *point = pivot + Vec3{cosine * from.x + sine * from.y,
                              cosine * from.y - sine * from.x, from.z};
    }
}

Camera with_lens(Camera c, const CameraOptions& o, const Terrain& t) {
    if (!o.f_stop) return c;
    const double focal_length =
        o.focal_length.value_or(o.sensor_width / (2.0 * std::tan(0.5 * c.field_of_view)));
    c.aperture = 1e-3 * focal_length / *o.f_stop;
    c.focus_distance = o.focus            ? seen(c, above_ground(*o.focus, t)).z
                       : o.focus_distance ? o.focus_distance->in(t.width())
                                          : length(c.target - c.eye);
    return c;
}

Camera of_drawing(Camera c, const CameraOptions& options) {
    const auto drawn = svg_camera(*options.drawing);
    if (!drawn)
        throw bad_request(
            "camera '{}': {} names no camera; use one that cydonia frame-for-sketch made",
            options.name, options.drawing->name());
    c.eye = drawn->eye, c.target = drawn->target;
    c.field_of_view = drawn->field_of_view;
    return c;
}

}  // namespace

double field_of_view(const CameraOptions& options) {
    if (!options.focal_length) return options.field_of_view;
    return 2.0 * std::atan(0.5 * options.sensor_width / *options.focal_length);
}

Camera place(const CameraOptions& options, const Terrain& land, Quality quality,
             const std::optional<WaterOptions>& flood) {
    using Kind = CameraOptions::Kind;
    const Terrain terrain = surface_of(land, flood);
    Camera camera;
    camera.width = scaled(options.size[0], quality);
    camera.height = scaled(options.size[1], quality);
    camera.field_of_view = field_of_view(options);
    switch (options.kind) {
        case Kind::kOverhead:
            return overhead(camera, terrain);
        case Kind::kOblique:
            camera = oblique(camera, options, terrain);
            break;
        case Kind::kOrbit:
            camera = orbit(camera, options, terrain);
            break;
        case Kind::kLookAt:
            camera = look_at(camera, options, terrain);
            break;
        case Kind::kStand:
            camera = stand(camera, options, terrain);
            break;
        case Kind::kPath:
            camera = on_path(camera, options, terrain);
            break;
        case Kind::kDrawing:
            camera = of_drawing(camera, options);
            break;
    }
    turn(camera, options, terrain);
    check_axis(camera, options, terrain);
    level(camera);
    camera = with_lens(camera, options, terrain);
    check_eye(camera, options, terrain, land);
    check_view(camera, options, terrain);
    check_focus(camera, options);
    return camera;
}

bool can_turn(const CameraOptions& options) {
    using Kind = CameraOptions::Kind;
    return options.kind == Kind::kOblique || options.kind == Kind::kOrbit ||
           options.kind == Kind::kLookAt;
}

std::vector<CameraOptions> default_cameras() {
    CameraOptions overhead, oblique;
    overhead.name = "overhead";
    overhead.kind = CameraOptions::Kind::kOverhead;
    overhead.size = {1080, 1080};
    oblique.name = "oblique";
    oblique.elevation = radians(12.0);  // low enough for some sky
    return {overhead, oblique};
}

}  // namespace cydonia::render
