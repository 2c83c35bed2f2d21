#pragma once

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/texture/options.h"

namespace cydonia::texture {

// Land made of real land, in place of the land so far (Gain, Merry and Marais 2015). A
// cell depends on a bounded part of the plane around it: any window of it can be made
// alone. Throws bad_request.
Terrain run(const Options& options, const Terrain& terrain, const Context& context);

inline constexpr int kVersion = 1;  // raised when the same options give other heights

}  // namespace cydonia::texture
