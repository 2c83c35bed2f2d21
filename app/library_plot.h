#pragma once

#include <string>

#include "synth/statistics/similarity.h"

namespace cydonia {

// A drawing (SVG) of a library at one level of detail: for each quantity a row a type,
// and in it of every example the mean and, left and right of it, the standard deviation.
// With a land, it is the row below all types.
std::string library_plot(const statistics::Library& library, double level,
                         const std::string& land_name = {},
                         const statistics::Analysis* land = nullptr);

}  // namespace cydonia
