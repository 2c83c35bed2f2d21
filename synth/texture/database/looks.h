#pragma once

#include <array>
#include <cstdint>

#include "field/field.h"
#include "synth/texture/database/types.h"

namespace cydonia::texture {

// Land is looked at in blocks of kBlock by kBlock cells: types are not asked for finer.
inline constexpr int kBlock = 1 << kFinestGuided;

// What a block's surroundings look like at three scales: steepness, relief, curvature.
using Look = std::array<float, 9>;

struct Looks {
    Field<Look> numbers;
    Field<std::uint8_t> level;  // 1: water, or as flat as it
};

Looks looks_of(const Field<float>& land, double spacing);

}  // namespace cydonia::texture
