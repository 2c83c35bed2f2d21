#pragma once

#include <vector>

#include "field/terrain.h"

namespace cydonia::pareidolia {

// The land that is bent: the base with other gradients, put together again. Where shadow
// is to lie they are calmed by `hidden` (0: not at all) and fall along the light; in the
// windows around it they fall by half as much, and are limited where the base is too
// steep for the sun to light it. `smoothed` takes by how much lit slopes were lessened, 0
// to 1.
Field<float> calmed(const Terrain& base, const std::vector<ShadowImage>& images,
                    double hidden, double* smoothed);

}  // namespace cydonia::pareidolia
