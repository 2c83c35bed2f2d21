#pragma once

#include <span>

#include "synth/detail/matching.h"

namespace cydonia::detail {

// How rough a land is around each of its cells, metres: root mean square of what one
// level of subdivision does not give. Of the land's shape.
Field<float> roughness_of(const Field<float>& land, Filter filter);

// How many times rougher a level's land is than what its blocks take their details from,
// by `land`, the roughness of the coarsest land, and `examples`', of theirs. So large, in
// a window of the blocks' land, `finer` levels finer than the coarsest.
Field<float> gain_of(int width, int height, const Window& window, const Blocks& blocks,
                     std::span<const Match> matches, const Field<float>& land,
                     std::span<const Field<float>> examples, int finer);

}  // namespace cydonia::detail
