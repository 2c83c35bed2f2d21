#pragma once

#include "field/terrain.h"
#include "synth/distance/options.h"
#include "synth/method.h"

namespace cydonia::distance {

// Rusnell 2009, Algorithm 3: makes terrain by least-cost distance from strokes and adds
// it to the terrain so far. Every cell may depend on the whole terrain. Throws
// bad_request for options that contradict the inputs (no generator, a rising profile, r
// >= mu_w).
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 2;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

}  // namespace cydonia::distance
