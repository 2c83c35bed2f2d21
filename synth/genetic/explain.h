#pragma once

#include <string>
#include <vector>

#include "field/image.h"
#include "synth/genetic/evolution/height_field.h"

namespace cydonia::genetic {

// Land under a light from the north-west, its small levels enlarged.
Field<Rgb8> relief_picture(const Field<float>& heights, double spacing);

// Fitness by cycle, a panel a level: of the fittest (black), of the population (grey),
// its compatibility (blue) and similarity (red), 0 to 1.
Field<Rgb8> fitness_picture(const std::vector<LevelDone>& levels);

// A line a level and cycle.
std::string fitness_table(const std::vector<LevelDone>& levels);

}  // namespace cydonia::genetic
