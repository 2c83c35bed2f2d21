#include "config/reader/readers.h"

namespace cydonia::config {

using render::CameraOptions;
using render::ColourOptions;
using render::GroundOptions;
using render::HazeOptions;
using render::SkyOptions;
using render::WaterOptions;

namespace {

constexpr Name<CameraOptions::Kind> kCameraKinds[] = {
    {"overhead", CameraOptions::Kind::kOverhead},
    {"oblique", CameraOptions::Kind::kOblique},
    {"orbit", CameraOptions::Kind::kOrbit},
    {"look_at", CameraOptions::Kind::kLookAt},
};

constexpr std::size_t kMostCameras = 64;

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

void read(Table& t, SkyOptions& sky) {
    t.field("turbidity", sky.turbidity, Number{from(1.9, 10.0)});
    t.field("fill", sky.fill, Number{from(0.0, 10.0)});
}

void read(Table& t, HazeOptions& haze) {
    t.field("visibility", haze.visibility, LengthUnit{at_least(0.0)});
}

void read(Table& t, WaterOptions& water) { t.field("level", water.level, LengthUnit{}); }

void read(Table& t, GroundOptions& ground) {
    t.field("snow_line", ground.snow_line, LengthUnit{});
    t.field("rock_slope", ground.rock_slope, Degrees{from(0.0, 90.0)});
    t.check(ground.rock_slope[0] <= ground.rock_slope[1], {"rock_slope"},
            "the slope where rock begins must not be above the one where all is rock");
}

void read(Table& t, ColourOptions& colour) {
    t.field("config", colour.config, File{});
    t.field("display", colour.display, Text{});
    t.field("view", colour.view, Text{});
    t.field("exposure", colour.exposure, Number{from(-20.0, 20.0)});
}

void read(Table& t, RenderTable& out) {
    auto& o = out.options;
    t.table("sun", o.sun);
    t.tables("camera", o.cameras, kMostCameras);
    t.unique("camera", "name");
    t.table("sky", o.sky);
    t.table("haze", o.haze);
    t.table("water", o.water);
    t.table("ground", o.ground);
    t.table("colour", o.colour);
    out.text = t.record().text();
}

}  // namespace cydonia::config
