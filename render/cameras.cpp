#include "render/cameras.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/sample.h"

namespace cydonia::render {
namespace {

constexpr int kSmallest = 16;         // pixels
constexpr double kSkyMargin = 0.22;   // of the frame's height, over the skyline
const double kSteep = radians(60.0);  // an oblique view from above this has no skyline
constexpr int kLooks = 256;           // samples a side that stand for the land in a frame

int scaled(int pixels, Quality quality) {
    const int thirds = 1 + static_cast<int>(quality);
    return std::max(kSmallest, (pixels * thirds + 1) / 3);
}

double aspect(const Camera& c) { return static_cast<double>(c.width) / c.height; }

// Half of the frame's height as an angle.
double half_height(const Camera& c) {
    return std::atan(std::tan(0.5 * c.field_of_view) / aspect(c));
}

Vec3 sample_point(const Terrain& t, int x, int y) {
    return {t.spacing * (x + 0.5), t.spacing * (t.heights.height() - y - 0.5),
            t.heights(x, y)};
}

// The height of the mesh over a place, of its border outside; close enough for a camera.
double ground_at(const Terrain& t, double east, double north) {
    return bilinear(t.heights, east / t.spacing - 0.5,
                    t.heights.height() - north / t.spacing - 0.5);
}

bool over_land(const Terrain& t, const Vec3& p) {
    return p.x >= 0.0 && p.y >= 0.0 && p.x <= t.width() && p.y <= t.depth();
}

double mean_height(const Terrain& t) {
    double sum = 0.0;
    for (const float h : t.heights) sum += h;
    return sum / static_cast<double>(t.heights.size());
}

Vec3 centre(const Terrain& t) {
    return {0.5 * t.width(), 0.5 * t.depth(), mean_height(t)};
}

// Calls visit(point) for samples all over the land, its border included.
template <class Visit>
void look_over(const Terrain& t, const Visit& visit) {
    const int w = t.heights.width(), h = t.heights.height();
    const int columns = std::min(w, kLooks), rows = std::min(h, kLooks);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            visit(sample_point(t, i * (w - 1) / (columns - 1), j * (h - 1) / (rows - 1)));
}

// A point as the camera sees it: to the right, up and forward, metres.
Vec3 seen(const Camera& c, const Vec3& p) {
    const Vec3 forward = normalized(c.target - c.eye);
    const Vec3 right = normalized(cross(forward, c.up));
    const Vec3 d = p - c.eye;
    return {dot(d, right), dot(d, cross(right, forward)), dot(d, forward)};
}

bool in_frame(const Camera& c, const Vec3& p) {
    const Vec3 s = seen(c, p);
    const double half = std::tan(0.5 * c.field_of_view) * s.z;
    return s.z > 0.0 && std::abs(s.x) <= half && std::abs(s.y) <= half / aspect(c);
}

// Straight up or down there is no "up" left: north takes its place.
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
    // The mesh, which ends at the outer cells' centres: no rim of what lies around it.
    c.frame_width = std::max(t.width() - t.spacing, (t.depth() - t.spacing) * aspect(c));
    return c;
}

// Around the centre, `distance` away.
Camera around(Camera c, const CameraOptions& o, const Terrain& t, double distance) {
    c.target = centre(t);
    c.eye = c.target + distance * direction_to({o.azimuth, o.elevation});
    level(c);
    return c;
}

// Whether the far half of the land's outline is between the frame's sides. The near half
// is cut by them, so that the land fills the frame.
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

// How far below the horizon a point is seen from the eye, in the vertical plane of the
// view.
double depression(const Camera& c, const Vec3& p) {
    const Vec3 ahead = normalized({c.target.x - c.eye.x, c.target.y - c.eye.y, 0.0});
    const double forward = dot(p - c.eye, ahead);
    return std::atan2(c.eye.z - p.z, forward);
}

// Turned until the highest skyline stands kSkyMargin below the frame's top.
void aim(Camera& c, const Terrain& t) {
    double skyline = radians(90.0);
    look_over(t, [&](const Vec3& p) {
        const Vec3 s = seen(c, p);
        if (std::abs(s.x) <= std::tan(0.5 * c.field_of_view) * s.z)
            skyline = std::min(skyline, depression(c, p));
    });
    const double down = skyline + half_height(c) * (1.0 - 2.0 * kSkyMargin);
    if (std::abs(down) > radians(80.0)) return;
    const Vec3 ahead{c.target.x - c.eye.x, c.target.y - c.eye.y, 0.0};
    c.target = c.eye + ahead + Vec3{0.0, 0.0, -length(ahead) * std::tan(down)};
}

// Whether the border of the near half of the land is in the frame.
bool near_edge_shows(const Camera& c, const Terrain& t) {
    const double inset =
        1.5 * std::max({t.spacing, t.width() / kLooks, t.depth() / kLooks});
    const double half_depth = seen(c, centre(t)).z;
    bool shows = false;
    look_over(t, [&](const Vec3& p) {
        const bool border = p.x < inset || p.y < inset || p.x > t.width() - inset ||
                            p.y > t.depth() - inset;
        shows = shows || (border && seen(c, p).z < half_depth && in_frame(c, p));
    });
    return shows;
}

// The largest distance below `too_far` that pleases.
template <class Pleases>
double farthest(double too_far, const Pleases& pleases) {
    double near = 0.0;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (near + too_far);
        (pleases(middle) ? near : too_far) = middle;
    }
    return near;
}

// From as far as the far side of the land still fills the frame and the near edge stays
// out of it.
Camera oblique(const Camera& c, const CameraOptions& o, const Terrain& t) {
    // The land's diagonal is longer than any side seen, so the answer lies below.
    const double too_far =
        2.0 * std::hypot(t.width(), t.depth()) / std::tan(0.5 * o.field_of_view);
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

Camera orbit(const Camera& c, const CameraOptions& o, const Terrain& t) {
    const double radius = 0.5 * std::hypot(t.width(), t.depth());
    const double whole = radius / std::sin(0.5 * o.field_of_view);
    return around(c, o, t, o.distance ? o.distance->in(t.width()) : whole);
}

Vec3 above_ground(const std::array<Length, 3>& p, const Terrain& t) {
    const double east = p[0].in(t.width()), north = p[1].in(t.width());
    return {east, north, ground_at(t, east, north) + p[2].in(t.width())};
}

Camera look_at(Camera c, const CameraOptions& o, const Terrain& t) {
    c.eye = above_ground(o.eye, t);
    c.target = above_ground(o.target, t);
    if (length(c.target - c.eye) < 1e-6 * t.spacing)
        throw bad_request(
            "camera '{}': eye and target are the same point of the land; move one",
            o.name);
    level(c);
    return c;
}

void check_eye(const Camera& c, const CameraOptions& o, const Terrain& t) {
    const double above = c.eye.z - ground_at(t, c.eye.x, c.eye.y);
    if (above > 0.0 || (!over_land(t, c.eye) && o.kind != CameraOptions::Kind::kLookAt))
        return;
    const char* fix = o.kind == CameraOptions::Kind::kLookAt
                          ? "its eye's third number, the height above the ground"
                      : o.kind == CameraOptions::Kind::kOrbit
                          ? "its elevation or its distance"
                          : "its elevation";
    throw bad_request("camera '{}' stands {:.3g} m under the ground: raise {}", o.name,
                      -above, fix);
}

void check_view(const Camera& c, const CameraOptions& o, const Terrain& t) {
    bool any = over_land(t, c.target);
    if (!any) look_over(t, [&](const Vec3& p) { any = any || in_frame(c, p); });
    if (!any)
        throw bad_request(
            "camera '{}' sees no land: it looks past it; move its target onto the land, "
            "{:.6g} m by {:.6g} m from the south-west corner",
            o.name, t.width(), t.depth());
}

// What a camera sees and stands on: water where there is some, else land.
Terrain surface_of(const Terrain& terrain) {
    Terrain surface;
    surface.heights = terrain.heights;
    surface.spacing = terrain.spacing;
    for (std::size_t i = 0; i < surface.heights.size(); ++i)
        surface.heights[i] += water_depth(terrain, i);
    return surface;
}

}  // namespace

Camera place(const CameraOptions& options, const Terrain& land, Quality quality) {
    const Terrain terrain = surface_of(land);
    Camera camera;
    camera.width = scaled(options.size[0], quality);
    camera.height = scaled(options.size[1], quality);
    camera.field_of_view = options.field_of_view;
    switch (options.kind) {
        case CameraOptions::Kind::kOverhead:
            return overhead(camera, terrain);
        case CameraOptions::Kind::kOblique:
            camera = oblique(camera, options, terrain);
            break;
        case CameraOptions::Kind::kOrbit:
            camera = orbit(camera, options, terrain);
            break;
        case CameraOptions::Kind::kLookAt:
            camera = look_at(camera, options, terrain);
            break;
    }
    check_eye(camera, options, terrain);
    check_view(camera, options, terrain);
    return camera;
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
