#pragma once

#include <string>
#include <string_view>

#include "field/quantise.h"
#include "render/cameras/view.h"
#include "render/scene/shot.h"
#include "render/scene/water.h"

// The .pov in pieces, each a block of text that says what it does. The pieces use the
// names that land_numbers() and light_numbers() declare.
namespace cydonia::render::pov {

// A line's worth of any bytes for a `//` comment: control bytes become spaces.
std::string comment(std::string_view text);
// A number as a person writes it: at most nine digits, no minus zero.
std::string number(double value);
// "a, b, c".
std::string numbers(const Vec3& v);
std::string numbers(const Rgb& colour);

// Whether light between the slopes is traced (radiosity) or taken from the visibility
// map.
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
// A sheet that throws the clouds' shadows: metres from the middle of the lowest ground.
struct CloudShade {
    std::string frame;
    Vec3 middle;
    double size;
};
std::string cloud_shade(const CloudShade& shade);
std::string ground(const Shot& shot);
std::string outskirts(const Shot& shot, const Heights16& heights, bool under_sea);
std::string flood(const Shot& shot);  // all that lies below one level
std::string water(const Shot& shot, const WaterSurface& surface);

}  // namespace cydonia::render::pov
