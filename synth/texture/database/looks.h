#pragma once

#include <array>
#include <cstdint>

#include "field/field.h"
#include "synth/texture/database/types.h"

namespace cydonia::texture {

// Land is described in blocks of kBlock by kBlock cells, as types are not asked for on
// finer levels.
inline constexpr int kBlock = 1 << kFinestGuided;

// Steepness, relief and curvature of a block's surroundings at three scales.
using Look = std::array<float, 9>;

struct Looks {
    Field<Look> numbers;
    Field<std::uint8_t> level;  // 1: water, or equally flat
};

Looks looks_of(const Field<float>& land, double spacing);

}  // namespace cydonia::texture
