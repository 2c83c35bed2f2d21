#pragma once

#include <vector>

#include "field/terrain.h"
#include "synth/context.h"
#include "synth/pareidolia/options.h"

namespace cydonia::pareidolia {

// Bends the base as little as its images allow, so that each is cast by its own sun.
// Returns heights in metres in the shape of the base. `images` receives the windows in
// which the images count and the cells where they are relaxed in favour of one another.
// `options.images` must be the same in number and order.
Field<float> constrained(const Options& options, const Terrain& base,
                         std::vector<ShadowImage>& images, const Context& context);

}  // namespace cydonia::pareidolia
