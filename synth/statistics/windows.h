#pragma once

#include "synth/statistics/analysis.h"

namespace cydonia::statistics {

// Land is analysed in windows of 60 samples a side, one around each block of 12. A window
// holds a dozen features or so, and a border between lands is found to within half a
// window.
inline constexpr int kBlock = 12, kBlocks = 5;

// The analysis of the window around each block, restricted to `inside`, which has the
// heights' shape; empty: everything is inside. Blocks with too little inside have no
// elevations (count 0). Each sample of a feature counts, so that a feature that a window
// cuts counts in part.
Field<Analysis> window_analyses(const Terrain& terrain,
                                const Field<std::uint8_t>& inside = {});

}  // namespace cydonia::statistics
