#pragma once

#include <span>

#include "synth/detail/matching.h"

namespace cydonia::detail {

// The roughness of a land around each of its cells, metres: the root mean square of the
// details of one level of subdivision. The result has the land's size.
Field<float> roughness_of(const Field<float>& land, Filter filter);

// How many times rougher a level's land is than the land from which its blocks take their
// details. `land` is the roughness of the coarsest land, `examples` that of each example.
// The result has width x height cells, in a window of the blocks' land, `finer` levels
// finer than the coarsest.
Field<float> gain_of(int width, int height, const Window& window, const Blocks& blocks,
                     std::span<const Match> matches, const Field<float>& land,
                     std::span<const Field<float>> examples, int finer);

}  // namespace cydonia::detail
