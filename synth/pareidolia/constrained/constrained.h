#pragma once

#include <vector>

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// The base bent as little as its images allow, so that each is cast by its own sun:
// heights in metres, same shape as the base. `images` receives the windows in which they
// count and the cells where they gave way to one another. `options.images` are the same
// in number and order.
Field<float> constrained(const Options& options, const Terrain& base,
                         std::vector<ShadowImage>& images, const Context& context);

}  // namespace cydonia::pareidolia
