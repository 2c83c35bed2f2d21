#pragma once

#include <vector>

#include "app/sequence/sequence.h"

namespace cydonia {

// The camera once around the land, clockwise from above, sun and land at rest: [frames]'s
// camera where that can turn, else the first that orbits, else one that has the whole
// land in its frame.
Sequence turntable(const config::FramesSpec& frames,
                   const std::vector<render::CameraOptions>& cameras);

}  // namespace cydonia
