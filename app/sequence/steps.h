#pragma once

#include <string>
#include <vector>

#include "app/pipeline/steps.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The steps of the scene's sequences (a day, a turntable, its film), in order: what is
// planned; every frame; the video and a sheet of frames. They need the finished `land`,
// and where POV-Ray draws them, the `checked` one.
std::vector<Step> sequence_steps(const Job& job, const std::vector<Need>& land,
                                 const std::vector<Need>& checked);

// Those of one sequence.
std::vector<std::string> sequence_targets(Kind kind, const Job& job);

}  // namespace cydonia
