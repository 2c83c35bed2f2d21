#pragma once

#include "field/terrain.h"
#include "synth/method.h"
#include "synth/sketch/options.h"

namespace cydonia::sketch {

// Adds landforms and regions to the land so far, given by their curves (Gain, Marais and
// Strasser 2009), in the order of the scene and each on the land that those before it
// made. Beyond all boundaries the land is unchanged to the bit. Adds figures of how far
// the land is from each silhouette. Throws bad_request, which names the curve.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 2;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

}  // namespace cydonia::sketch
