#pragma once

#include "config/reader/names.h"
#include "config/reader/table.h"
#include "synth/distance/options.h"

namespace cydonia::config {

// The parts of a distance stage. Names of groups are those before, in the file's order.
void read(Table& t, distance::Profile& profile);  // distance_costs.cpp
// Below zero only as a term of a sum.
enum class Sign { kNotNegative, kAny };
void read(Table& t, distance::CostRule& cost, const Names& names,
          const Sign& sign);                                // distance_costs.cpp
void read(Table& t, distance::Group& group, Names& names);  // distance_groups.cpp

}  // namespace cydonia::config
