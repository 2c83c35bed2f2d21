#pragma once

#include <span>
#include <vector>

#include "synth/detail/matching.h"

namespace cydonia::detail {

// Where blocks overlap, one fades into the other linearly (Brosz 2007, section 5.2). Of
// lands that have nothing to do with each other the sum would be calmer than each: it is
// raised to keep their variance (Heitz and Neyret 2018, section 3.3). kMean: as it is.
enum class Fading { kVariance, kMean };

// Details of a level whose coarse land is so large, a window of the blocks', each block's
// from its match. Nought where a block has no match.
Details quilted(int coarse_width, int coarse_height, const Window& window,
                const Blocks& blocks, std::span<const Match> matches,
                std::span<const Example> examples, int level, Filter filter,
                Fading fading);

}  // namespace cydonia::detail
