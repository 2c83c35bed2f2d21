#pragma once

#include <vector>

#include "app/pipeline/job.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The frames of a sequence by POV-Ray, those that are missing: frames/<frame>.exr and
// .png, and passes where the scene asks for them. Gives all files of the frames asked
// for.
Made film_by_povray(Job& job, const Sequence& sequence);

// Of those frames and of the ones whose light tells the exposure, which are not traced.
std::vector<std::size_t> frames_to_trace(Job& job, const Sequence& sequence);

// A look at it by Embree: frames/<sequence>-<style>-0001.png and so on.
Made film_by_embree(Job& job, const Sequence& sequence, render::Style style);

}  // namespace cydonia
