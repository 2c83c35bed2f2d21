#pragma once

#include <vector>

#include "field/terrain.h"

namespace cydonia::pareidolia {

// The land that is bent: the base, with gradients calmed and put together again (screened
// Poisson) where shadow is to lie, by `hidden` (0: not at all), and inside windows where
// the base is too steep for the sun to light it. `smoothed` takes by how much slopes
// inside the windows are less than the base's, 0 to 1.
Field<float> calmed(const Terrain& base, const std::vector<ShadowImage>& images,
                    double hidden, double* smoothed);

}  // namespace cydonia::pareidolia
