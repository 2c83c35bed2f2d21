#pragma once

#include "app/pipeline/steps.h"

namespace cydonia {

// report.html: one page of what the steps that it shows have made, as far as they are
// finished. Made again when any of it has changed.
Step report_step(const Job& job);

}  // namespace cydonia
