#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cydonia {

// The basic colour names of CSS, as sRGB. White is left out because it means that nothing
// is drawn.
struct ColourWord {
    std::string_view name;
    std::array<std::uint8_t, 3> value;
};
inline constexpr ColourWord kColourWords[] = {
    {"black", {0, 0, 0}},       {"silver", {192, 192, 192}}, {"gray", {128, 128, 128}},
    {"maroon", {128, 0, 0}},    {"red", {255, 0, 0}},        {"purple", {128, 0, 128}},
    {"fuchsia", {255, 0, 255}}, {"green", {0, 128, 0}},      {"lime", {0, 255, 0}},
    {"olive", {128, 128, 0}},   {"yellow", {255, 255, 0}},   {"navy", {0, 0, 128}},
    {"blue", {0, 0, 255}},      {"teal", {0, 128, 128}},     {"aqua", {0, 255, 255}},
    {"orange", {255, 165, 0}},
};

}  // namespace cydonia
