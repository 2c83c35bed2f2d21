#pragma once

#include <string>
#include <vector>

#include "app/pipeline/job.h"
#include "app/pipeline/step.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// Makes videos of a sequence's finished frames and a sheet of up to 48 of them:
// frames/<sequence>.mp4, .webp, .gif and .jpg. Previews are called <sequence>-<style>.
StepResult encode(const Sequence& sequence, const Job& job);
// The names of these files.
std::vector<std::string> files_of_reel(const std::string& sequence, const Job& job);

}  // namespace cydonia
