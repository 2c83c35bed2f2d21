#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/job.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// What a job is to film, and what the user should read about it.
struct SequencePlan {
    Sequence sequence;
    std::vector<std::string> messages = {};
    bool appears = true;  // the first image of a day
};

// A day follows the suns of images, which stages choose: its land must be finished.
SequencePlan plan_of(Kind kind, const Job& job);

// How many frames the whole sequence has; throws bad_request where there is nothing to
// film or frames asked for are beyond the last.
int check_plan(Kind kind, const Job& job);

// The frames asked for: all, or those of --frames A-B.
std::vector<std::size_t> frames_to_make(const Sequence& sequence, const Request& request);

Goal goal_of(Kind kind);
std::optional<Kind> sequence_of(Goal goal);  // none: of stills

}  // namespace cydonia
