#pragma once

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Land whose shadows show an image: Rusnell 2009, Algorithm 4, on the base terrain so
// far. Appends one ShadowImage per image to the result. Every cell may depend on the
// whole terrain. Throws bad_request for targets without shadow or a sun that cannot cast
// one.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 3;  // raised when the same options give other heights

}  // namespace cydonia::pareidolia
