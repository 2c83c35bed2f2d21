#pragma once

#include <string>
#include <string_view>

#include "field/quantise.h"
#include "render/cameras/view.h"
#include "render/scene/shot.h"
#include "render/scene/water.h"

// The pieces of a .pov, each a commented block of text. They use the names that
// land_numbers() and light_numbers() declare.
namespace cydonia::render::pov {

// A text of any bytes for a `//` comment; control characters become spaces.
std::string comment(std::string_view text);
// A number with at most nine digits; minus zero is zero.
std::string number(double value);
// "a, b, c".
std::string numbers(const Vec3& v);
std::string numbers(const Rgb& colour);

// Whether indirect light is traced (radiosity) or taken from the sky visibility map.
bool has_radiosity(Quality quality);

std::string land_numbers(const Heights16& heights, double spacing);
std::string light_numbers(const Shot& shot, double land_width);
std::string settings(const Shot& shot);
std::string camera(const Shot& shot);
std::string sun(const Shot& shot);
std::string sky(const Shot& shot);
std::string haze();
bool has_stars(const Shot& shot);
std::string stars(const Shot& shot);
// The sheet that casts the shadows of clouds: its middle relative to the middle of the
// land at its lowest height, and its side, metres.
struct CloudShade {
    std::string frame;
    Vec3 middle;
    double size;
};
std::string cloud_shade(const CloudShade& shade);
std::string ground(const Shot& shot);
std::string outskirts(const Shot& shot, const Heights16& heights, bool under_sea);
std::string flood(const Shot& shot);  // the water of WaterOptions
std::string water(const Shot& shot, const WaterSurface& surface);

}  // namespace cydonia::render::pov
