#pragma once

#include <vector>

#include "app/pipeline/graph.h"
#include "app/pipeline/job.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// Makes the missing frames of a sequence by POV-Ray: frames/<frame>.exr and .png, and
// passes if the scene asks for them. `graph` has the steps of the land. The outputs are
// all files of the frames asked for.
StepResult film_by_povray(const Job& job, const Sequence& sequence, Graph& graph);

// Which of those frames, and of the ones that determine the exposure, are not traced yet.
std::vector<std::size_t> frames_to_trace(const Job& job, const Sequence& sequence,
                                         Graph& graph);

// Makes previews of the frames by Embree: frames/<sequence>-<style>-0001.png and so on.
StepResult film_by_embree(const Job& job, const Sequence& sequence, render::Style style,
                          Graph& graph);
std::string file_of_look(const std::string& sequence, render::Style style, int index);

}  // namespace cydonia
