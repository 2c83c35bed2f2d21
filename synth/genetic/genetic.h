#pragma once

#include "field/terrain.h"
#include "synth/genetic/options.h"
#include "synth/method.h"

namespace cydonia::genetic {

// Land of the kinds that a map names, each like its examples in a terrain library
// (Saunders 2006): the map's boundaries refined and rasterised, a base level, then level
// by level down to the terrain's samples. Masks "type-NAME", 0 or 1; the picture "types".
// Figures: how like its type each kind of land has become, and how well seams are hidden.
// Throws bad_request, naming the region, type or model.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 1;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

}  // namespace cydonia::genetic
