#pragma once

#include "app/pipeline/job.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The videos of a sequence's finished frames, and a sheet of up to 48 of them:
// frames/<sequence>.mp4, .webp, .gif and .jpg; of a look, <sequence>-<style>.
Made encode(const Sequence& sequence, Job& job);

}  // namespace cydonia
