#pragma once

#include "field/terrain.h"
#include "synth/dem/options.h"
#include "synth/method.h"

namespace cydonia::dem {

// Replaces the land so far with a real elevation model. Heights are the model's, in
// metres above its own zero, times vertical_scale. Throws bad_request, which gives both
// sizes, when the window leaves the model.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 2;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

}  // namespace cydonia::dem
