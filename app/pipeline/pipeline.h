#pragma once

#include "app/request.h"
#include "field/error.h"
#include "field/progress.h"

namespace cydonia {

// From a scene file to `goal`, doing only what is not finished yet. Throws Error, also
// for a check that fell short (ExitCode::kCheckFellShort).
void make(const Request& request, Goal goal, Progress& progress);

}  // namespace cydonia
