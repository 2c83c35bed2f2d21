#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/pipeline/ledger.h"
#include "app/request.h"

namespace cydonia {

// What running a step gives: files, relative to the output folder, and what it learned.
struct Made {
    std::vector<std::string> outputs;
    Json result = Json::object();
};

// One line of the plan.
struct Step {
    std::string name;          // "check", "trace overhead"
    Goal goal;                 // the first goal that needs it
    std::uint64_t memory = 0;  // predicted peak, bytes
    // A hash of everything that goes in. Asked when the step's turn comes: it may read
    // what earlier steps wrote.
    std::function<std::uint64_t()> key;
    std::function<Made()> run;
    // Looks at the result, also of a step that was finished before, and throws to stop
    // here.
    std::function<void(const Json& result)> gate = {};
    // Refuses or warns before any work begins; asked only of a step that will run.
    std::function<void()> before = {};
};

}  // namespace cydonia
