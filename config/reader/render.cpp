#include "config/reader/readers.h"

namespace cydonia::config {

using render::ColourOptions;
using render::GroundOptions;
using render::HazeOptions;
using render::SkyOptions;
using render::WaterOptions;

namespace {

constexpr std::size_t kMostCameras = 64;

}  // namespace

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
