#pragma once

#include <vector>

#include "app/sequence/sequence.h"

namespace cydonia {

// The camera goes once around the land, clockwise seen from above, while sun and land
// stay. It is that of [frames] if it can turn, else the first that orbits, else one that
// sees the whole land.
Sequence turntable(const config::FramesSpec& frames,
                   const std::vector<render::CameraOptions>& cameras);

}  // namespace cydonia
