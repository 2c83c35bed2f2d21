#pragma once

#include "app/console.h"
#include "app/request.h"
#include "field/error.h"

namespace cydonia {

// Makes what the goal is for, doing only steps that are not finished yet. Throws Error,
// with ExitCode::kCheckFellShort if a shadow check fell short.
void make(const Request& request, Goal goal, Progress& progress);
// The same for a command, which ends with a note of where the files are.
void make(const Request& request, Goal goal, Console& console);

}  // namespace cydonia
