#pragma once

#include <string>
#include <vector>

#include "app/pipeline/steps.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The steps of the day, the turntable and the film of a scene: for each its plan, all its
// frames, and its videos with a sheet of frames. `land` are the needs of previews by
// Embree, `checked` those of frames by POV-Ray.
std::vector<Step> sequence_steps(const Job& job, const std::vector<Need>& land,
                                 const std::vector<Need>& checked);

// The ids of the steps of one sequence.
std::vector<std::string> sequence_targets(Kind kind, const Job& job);

}  // namespace cydonia
