#pragma once

#include <array>
#include <cstddef>

#include "field/image.h"

namespace cydonia {

// Of types in plots and maps; told apart by everybody (Okabe and Ito 2008). Beyond seven
// they come again.
struct TypeColour {
    const char *name, *hex;
    Rgb8 rgb;
};
inline constexpr std::array<TypeColour, 7> kTypeColours = {{
    {"blue", "#0072b2", {0x00, 0x72, 0xb2}},
    {"vermilion", "#d55e00", {0xd5, 0x5e, 0x00}},
    {"green", "#009e73", {0x00, 0x9e, 0x73}},
    {"pink", "#cc79a7", {0xcc, 0x79, 0xa7}},
    {"orange", "#e69f00", {0xe6, 0x9f, 0x00}},
    {"light blue", "#56b4e9", {0x56, 0xb4, 0xe9}},
    {"grey", "#444444", {0x44, 0x44, 0x44}},
}};
inline const TypeColour& type_colour(std::size_t type) {
    return kTypeColours[type % kTypeColours.size()];
}

}  // namespace cydonia
