// Light, air and the settings for tracing them.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "render/pov/pieces.h"
#include "render/scene/files.h"
#include "render/sky/haze.h"
#include "render/sky/sky.h"

namespace cydonia::render::pov {
namespace {

// Light from the sky and one bounce, gathered at few points from many directions and
// interpolated. The numbers were chosen by eye on mountains; higher ones cost minutes and
// show no difference.
std::string radiosity(Quality quality) {
    if (!has_radiosity(quality)) return "";
    const bool final = quality == Quality::kFinal;
    return fmt::format(R"(
    // Light from the sky and one bounce between the slopes.
    radiosity {{
        count {}, 4000 nearest_count {} error_bound {} recursion_limit 1
        pretrace_start 0.08 pretrace_end {} minimum_reuse {}
        normal off always_sample off brightness SkyFill
    }})",
                       final ? 160 : 80, final ? 10 : 8, final ? 0.4 : 0.5,
                       final ? 0.004 : 0.008, final ? 0.006 : 0.008);
}

}  // namespace

bool has_stars(const Shot& shot) {
    return shot.options.sky.moon > 0.0 && shot.options.sky.air &&
           shot.options.sky.clouds == Clouds::kNone &&
           shot.camera.projection == Camera::Projection::kPerspective;
}

std::string light_numbers(const Shot& shot, double land_width) {
    const Daylight light = daylight(shot.sun, shot.options.sky);
    std::string text = fmt::format(
        R"(// The sun, in degrees: clockwise from north, and above the horizon. The light's colours
// below and the sky's image belong to this height; 1 is what a white sheet sends back.
#declare SunAzimuth   = {};
#declare SunElevation = {};
#declare SunLight     = rgb <{}>;
#declare SkyLight     = rgb <{}>; // of the whole sky, on level ground
#declare SkyFill      = {}; // above 1 opens the shadows; the visible sky stays
)",
        number(degrees(shot.sun.azimuth)), number(degrees(shot.sun.elevation)),
        numbers(light.sun), numbers(light.sky), number(shot.options.sky.fill));
    if (has_haze(shot))
        text += fmt::format(
            R"(// What the air sends back as far as the camera looks. The sky's image stands behind this
// haze: change both together.
#declare HazeLight    = rgb <{}>;
#declare Visibility   = {:.3f}; // metres at which haze takes over
)",
            numbers(haze_light(shot)),
            visibility(shot.options.sky, shot.options.haze, land_width));
    return text + "\n";
}

std::string settings(const Shot& shot) {
    return fmt::format(R"(global_settings {{
    assumed_gamma 1.0{}
}}
#default {{ finish {{ ambient 0 diffuse 1 }} }}

)",
                       radiosity(shot.quality));
}

std::string sun(const Shot& shot) {
    // The sun's disc is 0.53 degrees across: soft edges where shadows are long.
    std::string disc;
    if (shot.quality != Quality::kDraft) {
        const int samples = shot.quality == Quality::kFinal ? 7 : 5;
        disc = fmt::format(R"(
    // Its disc, 0.53 degrees across.
    area_light 0.00925 * SunDistance * x, 0.00925 * SunDistance * y, {0}, {0}
    adaptive 1 jitter circular orient)",
                           samples);
    }
    return fmt::format(R"(#declare ToSun = Towards(
    sin(radians(SunAzimuth)) * cos(radians(SunElevation)),
    cos(radians(SunAzimuth)) * cos(radians(SunElevation)),
    sin(radians(SunElevation)));
#declare SunDistance = 100 * LandSize / Unit;
light_source {{
    Middle + SunDistance * ToSun
    color SunLight
    parallel point_at Middle{}
}}

)",
                       disc);
}

std::string sky(const Shot& shot) {
    return fmt::format(R"(// The whole sky around the land, the sun's disc left out.
sky_sphere {{
    pigment {{
        image_map {{ exr "{}" map_type 1 interpolate 2 }}
    }}
}}

)",
                       file_of(shot.name, ShotFile::kSky));
}

// As many stars as the eye sees; their number grows by 10^0.51 a magnitude. Each is a
// pixel wide in frames of any size.
std::string stars(const Shot& shot) {
    return fmt::format(R"(// Stars, behind all land.
#declare StarsAt = At({});
#declare StarDistance = 2000 * LandSize / Unit;
#declare StarSize = 0.7 * StarDistance * radians({}) / image_width;
#declare Chance = seed(7);
#for (I, 1, 5000)
    #declare StarUp = rand(Chance);
    #declare StarTurn = 360 * rand(Chance);
    #declare Brightness = min(pow(rand(Chance), -0.78), 30);
    #declare Warmth = rand(Chance) - 0.5;
    sphere {{
        StarsAt + StarDistance * vrotate(<sqrt(1 - StarUp * StarUp), StarUp, 0>, StarTurn * y)
        StarSize
        pigment {{ color rgb 1 }}
        finish {{ emission SkyLight + 0.04 * Brightness * <1 + Warmth / 4, 1, 1 - Warmth / 4> diffuse 0 }}
        no_shadow no_reflection no_radiosity
    }}
#end

)",
                       numbers(shot.camera.eye),
                       number(degrees(shot.camera.field_of_view)));
}

std::string cloud_shade(const CloudShade& shade) {
    return fmt::format(
        R"(// The shadows of the clouds: a sheet over all land that only the sun sees.
polygon {{
    5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>
    pigment {{
        image_pattern {{ png "{}" gamma 1.0 interpolate 2 once }}
        color_map {{ [0 rgbt <0, 0, 0, 0>] [1 rgbt <0, 0, 0, 1>] }}
    }}
    finish {{ diffuse 0 }}
    translate <-0.5, -0.5, 0> rotate 90 * x
    scale {} / Unit
    translate At(LandWidth / 2, LandDepth / 2, BaseHeight) + At({})
    no_image no_reflection no_radiosity
}}

)",
        file_of(shade.frame, ShotFile::kCloudShadows), number(shade.size),
        numbers(shade.middle));
}

// There is only one fog: POV-Ray adds the colours of several, and the horizon would glow.
std::string haze() {
    return fmt::format(
        R"(// Haze lies low: three quarters of it are gone HazeHeight above the lowest ground. At the
// distance called visibility 2 % of a contrast is left (Koschmieder): exp(-3.912).
#declare HazeHeight = {}; // metres
fog {{
    fog_type 2 up y
    distance Visibility / 3.912 / Unit
    fog_offset BaseHeight / Unit fog_alt HazeHeight / Unit
    color HazeLight
}}

)",
        number(kHazeHeight));
}

}  // namespace cydonia::render::pov
