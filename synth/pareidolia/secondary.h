#pragma once

#include "field/field.h"
#include "synth/distance/graph.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Rusnell 2009, Algorithm 4, step 7: complementary peaks, and ridges that are traced back
// to them over `layout`, a graph of the same ground that may be coarser or finer. No peak
// or end of a ridge lies in the anti-shadow `band`. Normalised noise places the heights
// between `base` and `bound`; they are kNowhere where there is no feature.
Field<float> secondary_features(const Options& options, const distance::Graph& layout,
                                const Field<float>& base, const Field<float>& bound,
                                const Field<std::uint8_t>& band, std::uint64_t seed);

}  // namespace cydonia::pareidolia
