#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/texture/constraints/window.h"

namespace cydonia::texture {

// What points and curves ask of a cell (section 5.1), blended where there are several.
struct Pull {
    float target = 0.0f;    // h_t, metres
    float distance = 0.0f;  // d, metres, to the nearest of them
    float reach =
        0.0f;  // a, metres: min(area, 4 cells of the level); 0: nothing is asked
};

// R of section 5.2, a set of types: bit t stands for type t.
using TypeSet = std::uint32_t;
inline constexpr TypeSet kAnyType = ~TypeSet{0};

}  // namespace cydonia::texture
