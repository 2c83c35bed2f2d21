#pragma once

#include <vector>

#include "app/pipeline/graph.h"
#include "app/pipeline/job.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// The frames of a sequence by POV-Ray, those that are missing: frames/<frame>.exr and
// .png, and passes where the scene asks for them. `graph` holds the land's steps. Gives
// all files of the frames asked for.
StepResult film_by_povray(const Job& job, const Sequence& sequence, Graph& graph);

// Of those frames, and of the ones whose light tells the exposure, which are not traced.
std::vector<std::size_t> frames_to_trace(const Job& job, const Sequence& sequence,
                                         Graph& graph);

// A look at it by Embree: frames/<sequence>-<style>-0001.png and so on.
StepResult film_by_embree(const Job& job, const Sequence& sequence, render::Style style,
                          Graph& graph);
std::string file_of_look(const std::string& sequence, render::Style style, int index);

}  // namespace cydonia
