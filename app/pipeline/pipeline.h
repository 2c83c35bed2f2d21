#pragma once

#include "app/console.h"
#include "app/request.h"
#include "field/error.h"

namespace cydonia {

// From a scene file to `goal`, doing only what is not finished yet. Throws Error, also
// for a check that fell short (ExitCode::kCheckFellShort).
void make(const Request& request, Goal goal, Progress& progress);
// The same as all that a command does: says at the end where everything is.
void make(const Request& request, Goal goal, Console& console);

}  // namespace cydonia
