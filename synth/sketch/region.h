#pragma once

#include "synth/sketch/landform.h"

namespace cydonia::sketch {

// The land inside a loop as rough as `noise` says in its finer half of scales; the others
// stay, and so does all beyond the loop (Gain, Marais and Strasser 2009, section 3.3).
void roughen(Field<float>& land, double spacing, const geometry::Shape& loop,
             const NoiseLevels& noise, int levels, std::uint64_t seed);

}  // namespace cydonia::sketch
