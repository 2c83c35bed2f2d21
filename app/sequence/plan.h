#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/job.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// A sequence that a job films.
struct SequencePlan {
    Sequence sequence;
    std::vector<std::string> messages = {};
    bool appears = true;  // whether the first image of a day does
};

// A day depends on the suns of images, which stages may choose: makes the land for it.
SequencePlan plan_of(Kind kind, const Job& job);

// The number of frames of the whole sequence. Throws bad_request if there is nothing to
// film or a frame asked for is beyond the last.
int check_plan(Kind kind, const Job& job);

// The frames to make: all, or those of --frames A-B.
std::vector<std::size_t> frames_to_make(const Sequence& sequence, const Request& request);

Goal goal_of(Kind kind);
std::optional<Kind> sequence_of(Goal goal);  // none if it films nothing

}  // namespace cydonia
