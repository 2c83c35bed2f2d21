#pragma once

#include <string>
#include <vector>

#include "app/pipeline/frame.h"
#include "app/pipeline/step.h"

namespace cydonia {

// Writes the scenes of a frame's pictures beside the files of its land; gives their names
// in that folder.
StepResult write_pictures(const Job& job, const Site& site, const Frame& frame);
// The .pov and .ini of each where that folder is pov/.
std::vector<std::string> files_of_pictures(const Frame& frame);

}  // namespace cydonia
