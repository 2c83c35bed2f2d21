#pragma once

#include <vector>

#include "app/pipeline/ledger.h"
#include "app/request.h"

namespace cydonia {

// A request as manifests and farm records keep it: the goals, and those options that
// change the files.
struct Command {
    std::vector<Goal> goals;
    Request request;  // without scene, output folder and threads
};

Json json_of(const Command& command);
// Throws bad_request for words that this version does not know and values out of range,
// and Json::exception for JSON of another form.
Command command_of(const Json& json);

}  // namespace cydonia
