#pragma once

#include "field/terrain.h"
#include "synth/genetic/options.h"
#include "synth/method.h"

namespace cydonia::genetic {

// Makes land of the types that a map names, similar to their examples in a terrain
// library (Saunders 2006). The map's boundaries are refined and rasterised, then a base
// level is made, and then finer levels down to the terrain's samples. Adds the masks
// "type-NAME", 0 or 1, the picture "types", and figures of how similar each region is to
// its type and how well seams are hidden. Throws bad_request, which names the region,
// type or model.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 1;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

}  // namespace cydonia::genetic
