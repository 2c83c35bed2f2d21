#include "render/cameras/checks.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "render/cameras/view.h"

namespace cydonia::render {
namespace {

using Kind = CameraOptions::Kind;

// Rays across and down a frame that look for land which no sample stands for.
constexpr int kRaysAcross = 33, kRaysDown = 19;

double floor_below(const Terrain& surface, const Vec3& eye) {
    return over_land(surface, eye) ? ground_at(surface, eye.x, eye.y)
                                   : outskirts_height(surface);
}

const char* height_of(Kind kind) {
    switch (kind) {
        case Kind::kLookAt:
            return "its eye's third number, the height above the ground";
        case Kind::kStand:
            return "its eye_height";
        case Kind::kOrbit:
            return "its elevation or its distance";
        case Kind::kDrawing:
            return "the eye of the camera in its drawing";
        default:
            return "its elevation";
    }
}

const char* direction_of(const CameraOptions& options) {
    switch (options.kind) {
        case Kind::kStand:
            return options.looks_at_target ? "its target" : "its heading and pitch";
        case Kind::kPath:
            return "the targets of its keys";
        case Kind::kLookAt:
            return "its target";
        case Kind::kDrawing:
            return "its drawing";
        default:
            return "its elevation, or widen its field_of_view,";
    }
}

// "12.3 degrees clockwise from north and 4.5 up".
std::string way_text(const Vec3& way) {
    double heading = degrees(std::atan2(way.x, way.y));
    if (heading < 0.0) heading += 360.0;
    const double pitch = degrees(std::atan2(way.z, std::hypot(way.x, way.y)));
    return fmt::format("{:.1f} degrees clockwise from north and {:.1f} {}", heading,
                       std::abs(pitch), pitch < 0.0 ? "down" : "up");
}

// The frames of the keys before and after one that is between.
std::string keys_around(const CameraOptions& options, double frame) {
    const auto after =
        std::ranges::upper_bound(options.keys, frame, {}, &CameraKey::frame);
    if (after == options.keys.begin() || after == options.keys.end())
        return fmt::format("the key at {:g}", frame);
    return fmt::format("the keys at {:g} and {:g}", (after - 1)->frame, after->frame);
}

bool rays_meet(const Camera& c, const Terrain& surface) {
    const Vec3 forward = normalized(c.target - c.eye);
    const Vec3 right = normalized(cross(forward, c.up)), up = cross(right, forward);
    const double half = std::tan(0.5 * c.field_of_view);
    for (int j = 0; j < kRaysDown; ++j)
        for (int i = 0; i < kRaysAcross; ++i) {
            const double x = half * (2.0 * i / (kRaysAcross - 1) - 1.0);
            const double y = half / aspect(c) * (2.0 * j / (kRaysDown - 1) - 1.0);
            if (where_it_meets(surface, c.eye, normalized(forward + x * right + y * up)))
                return true;
        }
    return false;
}

}  // namespace

void check_keys(const CameraOptions& o) {
    if (o.keys.size() < 2)
        throw bad_request("camera '{}': a path needs two keys or more, not {}", o.name,
                          o.keys.size());
    for (std::size_t i = 1; i < o.keys.size(); ++i)
        if (!(o.keys[i].frame > o.keys[i - 1].frame))
            throw bad_request(
                "camera '{}': the key at frame {:g} stands after the one at {:g}; put "
                "its keys in order of frames, each at a frame of its own",
                o.name, o.keys[i].frame, o.keys[i - 1].frame);
}

void check_path(const CameraOptions& o, const TimedCurve& eye, const TimedCurve& target,
                const Terrain& surface) {
    const double last = o.keys.back().frame;
    for (double frame = o.keys.front().frame; frame <= last; frame += 1.0) {
        const Vec3 at = eye(frame);
        const double above = at.z - floor_below(surface, at);
        if (above <= 0.0)
            throw bad_request(
                "camera '{}' is {:.3g} m under the ground or water at frame {:g}: raise "
                "the eyes of {}, or put a key between",
                o.name, -above, frame, keys_around(o, frame));
        if (length(target(frame) - at) < 1e-6 * surface.spacing)
            throw bad_request(
                "camera '{}': eye and target are the same point at frame {:g}: move the "
                "eyes or the targets of {} apart",
                o.name, frame, keys_around(o, frame));
    }
}

void check_axis(const Camera& c, const CameraOptions& o, const Terrain& surface) {
    if (length(c.target - c.eye) < 1e-6 * surface.spacing)
        throw bad_request(
            "camera '{}': eye and target are the same point of the land; move one",
            o.name);
}

void check_eye(const Camera& c, const CameraOptions& o, const Terrain& surface,
               const Terrain& land) {
    const double above = c.eye.z - floor_below(surface, c.eye);
    if (above > 0.0) return;
    const bool wet =
        over_land(land, c.eye) && c.eye.z > ground_at(land, c.eye.x, c.eye.y);
    throw bad_request("camera '{}' stands {:.3g} m under the {}: raise {}", o.name,
                      -above, wet ? "water" : "ground", height_of(o.kind));
}

void check_view(const Camera& c, const CameraOptions& o, const Terrain& surface) {
    bool any = false;
    look_over(surface, [&](const Vec3& p) { any = any || in_frame(c, p); });
    if (any || rays_meet(c, surface)) return;
    const Vec3 middle{0.5 * surface.width(), 0.5 * surface.depth(),
                      ground_at(surface, 0.5 * surface.width(), 0.5 * surface.depth())};
    throw bad_request(
        "camera '{}' sees no land: it looks {}, past it; change {} so that it looks {}, "
        "to the middle of the land",
        o.name, way_text(c.target - c.eye), direction_of(o), way_text(middle - c.eye));
}

void check_focus(const Camera& c, const CameraOptions& o) {
    if (c.aperture <= 0.0 || c.focus_distance > 0.0) return;
    throw bad_request(
        "camera '{}' is focused {:.3g} m behind itself: move its focus to a point in "
        "front "
        "of it",
        o.name, -c.focus_distance);
}

}  // namespace cydonia::render
