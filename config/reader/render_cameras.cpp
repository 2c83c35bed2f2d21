#include "config/reader/readers.h"

namespace cydonia::config {

using render::CameraOptions;

namespace {

constexpr Name<CameraOptions::Kind> kCameraKinds[] = {
    {"overhead", CameraOptions::Kind::kOverhead},
    {"oblique", CameraOptions::Kind::kOblique},
    {"orbit", CameraOptions::Kind::kOrbit},
    {"look_at", CameraOptions::Kind::kLookAt},
};

}  // namespace

void read(Table& t, CameraOptions& camera) {
    using Kind = CameraOptions::Kind;
    t.required("name", camera.name, Word{});
    t.field("kind", camera.kind, one_of(kCameraKinds));
    t.field("azimuth", camera.azimuth, kAzimuth);
    t.field("elevation", camera.elevation, Degrees{between(0.0, 90.0)});
    t.field("distance", camera.distance, LengthUnit{above(0.0)});
    t.field("eye", camera.eye, LengthUnit{});
    t.field("target", camera.target, LengthUnit{});
    t.field("field_of_view", camera.field_of_view, Degrees{from(1.0, 170.0)});
    t.field("size", camera.size, Whole{16, 16384});
    t.table("sun", camera.sun);

    const bool around = camera.kind == Kind::kOblique || camera.kind == Kind::kOrbit;
    const bool free = camera.kind == Kind::kLookAt;
    t.only_if(around, {"azimuth", "elevation"}, "kind = \"oblique\" or \"orbit\"");
    t.only_if(camera.kind == Kind::kOrbit, {"distance"}, "kind = \"orbit\"");
    t.only_if(free, {"eye", "target"}, "kind = \"look_at\"");
    t.only_if(around || free, {"field_of_view"}, "a camera with perspective");
    t.check(!free || (t.has("eye") && t.has("target")), {"kind"},
            "a look_at camera needs an eye and a target");
    t.check(!free || camera.eye != camera.target, {"target", "eye"},
            "the eye and the target are the same point");
}

}  // namespace cydonia::config
