#include <fmt/format.h>

#include "config/reader/readers.h"

namespace cydonia::config {

using render::CameraKey;
using render::CameraOptions;

namespace {

// The values of camera keys cannot vary in time, because the keys themselves are moments.
template <class Unit>
struct Fixed : Unit {
    static constexpr bool kVaries = false;
};
using KeyFrame = Fixed<Number>;

constexpr std::size_t kMostKeys = 1024;
constexpr const char* kPerspective = "a camera with perspective";

void read_lens(Table& t, CameraOptions& camera) {
    t.field("field_of_view", camera.field_of_view, Degrees{from(1.0, 170.0)});
    t.field("focal_length", camera.focal_length, Number{from(1.0, 5000.0)});
    t.field("sensor_width", camera.sensor_width, Number{from(1.0, 1000.0)});
    t.field("f_stop", camera.f_stop, Number{from(1e-4, 256.0)});
    t.field("focus_distance", camera.focus_distance, LengthUnit{above(0.0)});
    t.field("focus", camera.focus, LengthUnit{});

    t.only_if(camera.kind != CameraOptions::Kind::kOverhead,
              {"field_of_view", "focal_length", "sensor_width", "f_stop"}, kPerspective);
    t.only_if(camera.kind != CameraOptions::Kind::kDrawing,
              {"field_of_view", "focal_length"}, "a camera that is not a drawing's");
    t.check(!camera.focal_length || !t.has("field_of_view"),
            {"field_of_view", "focal_length"},
            "the focal length and the sensor's width already say how much is in view; "
            "leave one out");
    t.only_if(t.has("focal_length") || t.has("f_stop"), {"sensor_width"},
              "a focal_length or an f_stop");
    t.only_if(t.has("f_stop"), {"focus_distance", "focus"}, "an f_stop");
    t.check(!camera.focus || !camera.focus_distance, {"focus", "focus_distance"},
            "what is sharp is given twice; leave focus or focus_distance out");
}

void read_shutter(Table& t, CameraOptions& camera) {
    t.field("shutter_angle", camera.shutter_angle, Degrees{above_to(0.0, 360.0)});
    t.field("shutter_samples", camera.shutter_samples, Whole{1, 256});
}

// Reads the position of the camera.
void read_place(Table& t, CameraOptions& camera) {
    using Kind = CameraOptions::Kind;
    t.field("azimuth", camera.azimuth, kAzimuth);
    t.field("elevation", camera.elevation, Degrees{between(0.0, 90.0)});
    t.field("distance", camera.distance, LengthUnit{above(0.0)});
    t.field("eye", camera.eye, LengthUnit{});
    t.field("target", camera.target, LengthUnit{});
    t.field("position", camera.position, LengthUnit{});
    t.field("eye_height", camera.eye_height, LengthUnit{above(0.0)});
    t.field("heading", camera.heading, kAzimuth);
    t.field("pitch", camera.pitch, Degrees{from(-90.0, 90.0)});
    t.field("drawing", camera.drawing, File{});
    t.tables("key", camera.keys, kMostKeys);
    t.field("eased", camera.eased, Flag{});
    camera.looks_at_target = t.has("target");

    const bool around = camera.kind == Kind::kOblique || camera.kind == Kind::kOrbit;
    const bool free = camera.kind == Kind::kLookAt, stands = camera.kind == Kind::kStand;
    t.only_if(around, {"azimuth", "elevation"}, "kind = \"oblique\" or \"orbit\"");
    t.only_if(camera.kind == Kind::kOrbit, {"distance"}, "kind = \"orbit\"");
    t.only_if(free, {"eye"}, "kind = \"look_at\"");
    t.only_if(free || stands, {"target"}, "kind = \"look_at\" or \"stand\"");
    t.only_if(stands, {"position", "eye_height", "heading", "pitch"}, "kind = \"stand\"");
    t.only_if(camera.kind == Kind::kPath, {"key", "eased"}, "kind = \"path\"");
    t.only_if(camera.kind == Kind::kDrawing, {"drawing"}, "kind = \"drawing\"");
    t.check(camera.kind != Kind::kDrawing || camera.drawing, {"kind"},
            "a camera of a drawing needs the drawing: drawing = \"view.svg\"");
    t.check(!free || (t.has("eye") && t.has("target")), {"kind"},
            "a look_at camera needs an eye and a target");
    t.check(!free || camera.eye != camera.target, {"target", "eye"},
            "the eye and the target are the same point");
    t.check(!stands || t.has("position"), {"kind"},
            "a standing camera needs a position: [east, north]");
    t.check(!stands || !camera.looks_at_target || !(t.has("heading") || t.has("pitch")),
            {"target"},
            "it looks at its target or along heading and pitch; leave one out");
}

// Checks that the keys are in the order of their frames.
void check_order(Table& t, const CameraOptions& camera) {
    const auto& keys = camera.keys;
    t.check(camera.kind != CameraOptions::Kind::kPath || keys.size() >= 2,
            {"key", "kind"}, "a path needs two keys or more: [[render.camera.key]]");
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (!(keys[i].frame > keys[i - 1].frame))
            t.check(false, {"key"},
                    fmt::format("the key at frame {:g} stands after the one at {:g}; put "
                                "them in order of frames, each at a frame of its own",
                                keys[i].frame, keys[i - 1].frame));
}

}  // namespace

void read(Table& t, CameraKey& key) {
    t.required("frame", key.frame, KeyFrame{{from(-100'000.0, 100'000.0)}});
    const bool eye = t.required("eye", key.eye, Fixed<LengthUnit>{});
    const bool target = t.required("target", key.target, Fixed<LengthUnit>{});
    t.check(!eye || !target || key.eye != key.target, {"target"},
            "the eye and the target are the same point");
}

void read(Table& t, CameraOptions& camera) {
    t.required("name", camera.name, Word{});
    t.field("kind", camera.kind, one_of(render::kCameraKinds));
    read_place(t, camera);
    check_order(t, camera);
    read_lens(t, camera);
    read_shutter(t, camera);
    t.field("exposure", camera.exposure, Number{from(-20.0, 20.0)});
    t.field("size", camera.size, Whole{16, 16384});
    t.table("sun", camera.sun);
}

}  // namespace cydonia::config
