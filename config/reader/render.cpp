#include <algorithm>
#include <bit>
#include <set>

#include "config/reader/looks.h"
#include "config/reader/readers.h"
#include "field/error.h"
#include "field/primaries.h"

namespace cydonia::config {

using render::ColourOptions;
using render::FineReliefOptions;
using render::GroundOptions;
using render::HazeOptions;
using render::Pass;
using render::PassOptions;
using render::SkyOptions;
using render::WaterOptions;

namespace {

constexpr std::size_t kMostCameras = 64;

constexpr Name<render::Around> kAround[] = {
    {"level", render::Around::kLevel},
    {"land", render::Around::kLand},
};
constexpr Name<render::Clouds> kClouds[] = {
    {"none", render::Clouds::kNone},
    {"cirrus", render::Clouds::kCirrus},
    {"broken", render::Clouds::kBroken},
    {"overcast", render::Clouds::kOvercast},
};

// Added before the view transform at night, because a frame's own exposure would make it
// look like day.
constexpr double kNightExposure = -1.8;  // EV
// Added under an overcast sky, whose white would leave the land dark.
constexpr double kOvercastExposure = 0.7;

// A sun for lighting, which may be as low as at the end of civil twilight.
struct Lighting {};
void read(Table& t, Sun& sun, Lighting) {
    t.required("azimuth", sun.azimuth, kAzimuth);
    t.required("elevation", sun.elevation, Degrees{from(-6.0, 89.9)});
}

bool is_snow(const render::Layer& layer) {
    return layer.role == render::Layer::Role::kSnow;
}

// Sets the materials and the defaults of the light from a look. The scene's own tables
// are read after it and override it.
void choose_look(Table& t, render::Options& o) {
    Source file = default_look();
    t.field("look", file, LookName{});
    try {
        LookFile look = read_look(file);
        for (const Source& material : look.materials) t.shipped("look", material.path);
        o.ground.look = std::move(look.look);
        o.sky = look.sky;
        o.haze = look.haze;
        o.fine_relief = look.fine_relief;
        o.colour.exposure = look.exposure;
    } catch (const Error& error) {
        t.check(false, {"look"}, error.what());
    }
}

}  // namespace

void read(Table& t, SkyOptions& sky) {
    t.field("turbidity", sky.turbidity, Number{from(1.9, 10.0)});
    t.field("fill", sky.fill, Number{from(0.0, 10.0)});
    t.field("ground_albedo", sky.ground_albedo, Number{from(0.0, 1.0)});
    t.field("air", sky.air, Flag{});
    t.field("dust", sky.dust, Number{from(0.0, 1.0)});
    if (sky.dust) sky.dust = rec709_from_acescg(*sky.dust);
    t.field("clouds", sky.clouds, one_of(kClouds));
    t.field("cloud_shadows", sky.cloud_shadows, Flag{}, "auto");
    t.field("moon", sky.moon, Number{from(0.0, 1.0)});
}

void read(Table& t, HazeOptions& haze) {
    t.field("visibility", haze.visibility, LengthUnit{at_least(0.0)}, "auto");
}

void read(Table& t, WaterOptions& water) { t.field("level", water.level, LengthUnit{}); }

void read(Table& t, GroundOptions& ground) {
    t.field("around", ground.around, one_of(kAround));
    t.field("snow_line", ground.snow_line, LengthUnit{});
    t.field("rock_slope", ground.rock_slope, Degrees{from(0.0, 90.0)});
    t.check(!ground.rock_slope || (*ground.rock_slope)[0] <= (*ground.rock_slope)[1],
            {"rock_slope"},
            "the slope where rock begins must not be above the one where all is rock");
}

void read(Table& t, FineReliefOptions& fine) {
    t.field("factor", fine.factor, Whole{1, 8}, "auto");
    t.check(!fine.factor || std::has_single_bit(static_cast<unsigned>(*fine.factor)),
            {"factor"}, "1, 2, 4 or 8");
    t.field("gullies", fine.gullies, Number{from(0.0, 3.0)});
    t.field("crags", fine.crags, Number{from(0.0, 3.0)});
    t.field("terraces", fine.terraces, Number{from(0.0, 1.0)});
    t.field("step", fine.step, Number{from(0.1, 1e4)});
    t.field("craters", fine.craters, Number{from(0.0, 3.0)});
    t.only_if(fine.terraces > 0.0, {"step"}, "terraces above 0");
}

void read(Table& t, ColourOptions& colour) {
    t.field("config", colour.config, File{});
    t.field("display", colour.display, Text{});
    t.field("view", colour.view, Text{});
    t.field("exposure", colour.exposure, Number{from(-20.0, 20.0)});
}

void read(Table& t, PassOptions& passes) {
    t.field("which", passes.which, one_of(render::kPasses));
    const std::set<Pass> different(passes.which.begin(), passes.which.end());
    t.check(!different.empty() && different.size() == passes.which.size(), {"which"},
            "name at least one pass, and none twice");
    t.field("separate", passes.separate, Flag{});
}

void read(Table& t, RenderTable& out) {
    auto& o = out.options;
    choose_look(t, o);
    t.table("sun", o.sun, Lighting{});
    t.tables("thing", o.things, render::kMostKinds);
    t.tables("camera", o.cameras, kMostCameras);
    t.unique("camera", "name");
    t.table("sky", o.sky);
    t.table("haze", o.haze);
    t.table("water", o.water);
    t.table("ground", o.ground);
    t.table("fine_relief", o.fine_relief);
    t.check(
        !o.ground.snow_line || std::ranges::any_of(o.ground.look.layers, is_snow),
        {"ground"},
        "the look '" + o.ground.look.name + "' has no snow that a snow_line could move");
    if (o.sky.moon > 0.0)
        o.colour.exposure += kNightExposure;
    else if (o.sky.clouds == render::Clouds::kOvercast)
        o.colour.exposure += kOvercastExposure;
    t.table("colour", o.colour);
    t.table("passes", o.passes);
    out.text = t.record().text();
}

}  // namespace cydonia::config
