#pragma once

#include <string>
#include <vector>

#include "app/pipeline/frame.h"
#include "app/pipeline/step.h"

namespace cydonia {

// Writes the .pov and other files of a frame's pictures into the folder of its land. The
// outputs are names in that folder.
StepResult write_pictures(const Job& job, const Site& site, const Frame& frame);
// Those that every picture has, of a frame whose land is in pov/.
std::vector<std::string> files_of_pictures(const Frame& frame);

}  // namespace cydonia
