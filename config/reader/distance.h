#pragma once

#include "config/reader/names.h"
#include "config/reader/table.h"
#include "synth/distance/options.h"

namespace cydonia::config {

// The parts of a distance stage. `names` are those of the groups before, in the file's
// order.
void read(Table& t, distance::Profile& profile);  // distance_costs.cpp
// Whether a cost may be below zero, as only a term of a sum may be.
enum class Sign { kNotNegative, kAny };
void read(Table& t, distance::CostRule& cost, const Names& names,
          const Sign& sign);                                // distance_costs.cpp
void read(Table& t, distance::Group& group, Names& names);  // distance_groups.cpp

}  // namespace cydonia::config
