#pragma once

#include <string_view>

#include "field/enum_names.h"

namespace cydonia::render {

// How a preview shows the land. The styles kGrey to kInk are those of J. Brosz, "Terrain
// Modeling by Example" (2007), section 6. A style is a value, a row of the table below
// and its colours in diagram.cpp.
enum class Style {
    kNatural,   // like the final frame: ground, sun, sky, haze, water, things
    kGrey,      // grey, lit by the sun without shadows
    kHeight,    // coloured by height: brown, green, red, orange, yellow, white
    kSlope,     // coloured by slope, from the steepest: yellow, red, green, grey
    kInk,       // pen strokes down the slopes that are dark or seen at a low angle
    kContours,  // lit, with lines of equal height and a grid, both at round intervals
    kRadiance,  // grey, crests brightened and hollows darkened
};
inline constexpr Name<Style> kStyles[] = {
    {"natural", Style::kNatural},  {"grey", Style::kGrey}, {"height", Style::kHeight},
    {"slope", Style::kSlope},      {"ink", Style::kInk},   {"contours", Style::kContours},
    {"radiance", Style::kRadiance}};
static_assert(is_complete(kStyles, Style::kRadiance));
constexpr std::string_view name_of(Style style) { return name_in(kStyles, style); }

}  // namespace cydonia::render
