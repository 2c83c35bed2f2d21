#pragma once

#include <span>
#include <vector>

#include "synth/detail/matching.h"

namespace cydonia::detail {

// Where blocks overlap, one fades into the other linearly (Brosz 2007, section 5.2). The
// sum of unrelated lands would be calmer than each of them; kVariance scales it to keep
// their variance (Heitz and Neyret 2018, section 3.3), kMean does not.
enum class Fading { kVariance, kMean };

// The details of a level with a coarse land of this size, which is a window of the
// blocks' land. Each block's details come from its match; they are 0 where it has none.
Details quilted(int coarse_width, int coarse_height, const Window& window,
                const Blocks& blocks, std::span<const Match> matches,
                std::span<const Example> examples, int level, Filter filter,
                Fading fading);

}  // namespace cydonia::detail
