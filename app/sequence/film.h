#pragma once

#include <vector>

#include "app/pipeline/job.h"

namespace cydonia {

// The steps of the scene's day, in order: what is planned and when the image appears;
// every frame; the video.
std::vector<Step> day_steps(Job& job);

}  // namespace cydonia
