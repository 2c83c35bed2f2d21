#pragma once

#include <optional>

#include "app/console.h"
#include "app/request.h"
#include "app/sequence/sequence.h"

namespace cydonia {

// A sequence whose frames many machines trace, with Slurm: they share the output folder,
// in whose farm/ are the scripts, the logs and a record of what was handed in.
struct FarmRequest {
    Request request;
    std::optional<Kind> sequence = {};  // none: the film of what moves, else a turntable
    std::optional<int> chunk = {};      // frames a task; none: by quality
    std::optional<int> minutes = {};    // of a task; none: by quality
};

// Hands in what is missing: the land, the frames, the rest. Dry: prints the scripts.
void farm(const FarmRequest& asked, Console& console);

// Prints how far it is. `request` names the scene, and an output folder if that is not
// the usual one.
void farm_status(const Request& request, Console& console);

// Of frames that are all traced: their pictures and passes, the videos, the report.
void farm_collect(const Request& request, Console& console);

}  // namespace cydonia
