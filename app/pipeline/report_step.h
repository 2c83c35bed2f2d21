#pragma once

#include "app/pipeline/steps.h"

namespace cydonia {

// Makes report.html, one page that shows the results of all finished steps that it is
// connected to. It is made again when any of them has changed.
Step report_step(const Job& job);

}  // namespace cydonia
