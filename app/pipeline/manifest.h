#pragma once

#include <vector>

#include "app/pipeline/job.h"

namespace cydonia {

// What the output folder holds and how it came about: inputs and their hashes, seed,
// versions, figures, suns, outputs, and timings. Of the same scene everything is equal
// but "timings".
Json manifest_of(const std::vector<Step>& steps, const Job& job);

}  // namespace cydonia
