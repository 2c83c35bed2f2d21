#pragma once

#include "synth/statistics/analysis.h"

namespace cydonia::genetic {

// Land is looked at through windows of 60 samples a side, one about each block of 12:
// they hold some dozen features, and a border between lands is found to half of one.
inline constexpr int kBlock = 12, kBlocks = 5;

// The analysis of the window about each block, as far as it is `inside` (same shape as
// the heights; empty: all is): blocks without enough of it have no elevations (count 0).
// Of features each sample counts, so that what a window cuts counts in part.
Field<Analysis> window_analyses(const Terrain& terrain,
                                const Field<std::uint8_t>& inside = {});

}  // namespace cydonia::genetic
