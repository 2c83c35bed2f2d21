#pragma once

#include <string>
#include <vector>

#include "app/pipeline/job.h"
#include "app/pipeline/step.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The videos of a sequence's finished frames, and a sheet of up to 48 of them:
// frames/<sequence>.mp4, .webp, .gif and .jpg; of a look, <sequence>-<style>.
StepResult encode(const Sequence& sequence, const Job& job);
// Those files.
std::vector<std::string> files_of_reel(const std::string& sequence, const Job& job);

}  // namespace cydonia
