#pragma once

#include "field/terrain.h"
#include "synth/dem/options.h"
#include "synth/method.h"

namespace cydonia::dem {

// A real elevation model in place of the land so far: heights as in the model, metres
// above its own zero, times vertical_scale. A cell depends on the model around it only.
// Throws bad_request, with both sizes, when the window leaves the model.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 2;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

}  // namespace cydonia::dem
