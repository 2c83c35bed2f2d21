#pragma once

#include <string>

#include "synth/statistics/similarity.h"

namespace cydonia {

// An SVG plot of a library at one level of detail. Each quantity has a row for each type,
// which shows every example's mean with one standard deviation to each side. `land`, if
// given, is the last row.
std::string library_plot(const statistics::Library& library, double level,
                         const std::string& land_name = {},
                         const statistics::Analysis* land = nullptr);

}  // namespace cydonia
