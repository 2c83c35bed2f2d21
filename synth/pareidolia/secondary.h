#pragma once

#include "field/field.h"
#include "synth/distance/graph.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Rusnell 2009, Algorithm 4, step 7: complementary peaks, and ridges traced back to them
// over `layout` (a graph of the same ground, however fine), whose ends keep out of the
// anti-shadow `band`. Heights lie between `base` and `bound` by normalised noise;
// kNowhere where no feature is.
Field<float> secondary_features(const Options& options, const distance::Graph& layout,
                                const Field<float>& base, const Field<float>& bound,
                                const Field<std::uint8_t>& band, std::uint64_t seed);

}  // namespace cydonia::pareidolia
