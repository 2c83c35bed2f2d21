#pragma once

#include "field/terrain.h"
#include "synth/method.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Land whose shadows show an image: Rusnell 2009, Algorithm 4, on the base terrain so
// far. Appends one ShadowImage per image to the result. Every cell may depend on the
// whole terrain. Throws bad_request for targets without shadow or a sun that cannot cast
// one.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 3;  // raised when the same options give other heights

Method method_of(const Options& options);
std::uint64_t peak_memory(const Options& options, std::uint64_t cells,
                          std::uint64_t threads);

}  // namespace cydonia::pareidolia
