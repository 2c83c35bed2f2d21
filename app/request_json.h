#pragma once

#include <vector>

#include "app/pipeline/ledger.h"
#include "app/request.h"

namespace cydonia {

// What was asked of a scene, as a manifest and a farm's record keep it: `goals`, and of
// the request what makes a difference to the files.
struct Command {
    std::vector<Goal> goals;
    Request request;  // without scene, output folder and threads
};

Json json_of(const Command& command);
// Throws bad_request for what this version does not know and values out of range, and
// Json::exception for what is no command.
Command command_of(const Json& json);

}  // namespace cydonia
