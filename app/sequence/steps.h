#pragma once

#include <vector>

#include "app/pipeline/job.h"

namespace cydonia {

// The steps of the scene's sequences (a day, a turntable, its film), in order: what is
// planned; every frame; the video and a sheet of frames.
std::vector<Step> sequence_steps(Job& job);

}  // namespace cydonia
