#pragma once

#include <vector>

#include "field/terrain.h"

namespace cydonia::pareidolia {

// Makes the land that is bent: the base with other gradients, integrated again. Where
// shadow must lie, the gradients are reduced by `hidden` (0 is not at all) and the land
// falls along the light. In the windows around it the land falls by half as much, and
// slopes are limited where the base is too steep for the sun to light it. `smoothed`
// receives by how much lit slopes were reduced, 0 to 1.
Field<float> calmed(const Terrain& base, const std::vector<ShadowImage>& images,
                    double hidden, double* smoothed);

}  // namespace cydonia::pareidolia
