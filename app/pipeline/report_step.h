#pragma once

#include <vector>

#include "app/pipeline/job.h"

namespace cydonia {

// report.html: one page of what those steps made, as far as they are finished. Made again
// when any of it has changed.
Step report_step(Job& job, std::vector<Step> shown);

}  // namespace cydonia
