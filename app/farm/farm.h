#pragma once

#include <optional>

#include "app/console.h"
#include "app/request.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// Films a sequence on many machines with Slurm. They share the output folder. Its farm/
// holds the scripts, the logs and a record of the submitted jobs.
struct FarmRequest {
    Request request;
    std::optional<Kind> sequence =
        {};                           // none: a film if anything moves, else a turntable
    std::optional<int> chunk = {};    // frames of a task; none: by quality
    std::optional<int> minutes = {};  // time limit of a task; none: by quality
};

// Submits what is missing: the land, the frames, and the rest. With dry_run, prints the
// scripts instead.
void farm(const FarmRequest& asked, Console& console);

// Prints the state of the jobs. `request` names the scene, and the output folder unless
// that is the usual one.
void farm_status(const Request& request, Console& console);

// When all frames are traced, makes pictures, passes, videos and the report.
void farm_collect(const Request& request, Console& console);

}  // namespace cydonia
