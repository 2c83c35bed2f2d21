#pragma once

#include <string>
#include <vector>

#include "field/image.h"
#include "synth/genetic/evolution/height_field.h"

namespace cydonia::genetic {

// A picture of land lit from the north-west. Small levels are enlarged.
Field<Rgb8> relief_picture(const Field<float>& heights, double spacing);

// A plot of fitness over cycles with a panel for each level, from 0 to 1: the fittest
// (black), the population (grey), and the fittest's compatibility (blue) and similarity
// (red).
Field<Rgb8> fitness_picture(const std::vector<LevelDone>& levels);

// A table with a line for each level and cycle.
std::string fitness_table(const std::vector<LevelDone>& levels);

}  // namespace cydonia::genetic
