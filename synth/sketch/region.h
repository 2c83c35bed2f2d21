#pragma once

#include "synth/sketch/landform.h"

namespace cydonia::sketch {

// Gives the land inside a loop the roughness of `noise` in the finer half of its scales.
// Coarser scales stay, and so does everything outside the loop (Gain, Marais and Strasser
// 2009, section 3.3).
void roughen(Field<float>& land, double spacing, const geometry::Shape& loop,
             const NoiseLevels& noise, int levels, std::uint64_t seed);

}  // namespace cydonia::sketch
