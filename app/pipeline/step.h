#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/pipeline/key.h"
#include "app/pipeline/ledger.h"

namespace cydonia {

class Graph;

// How a step depends on another one.
enum class Use {
    // On everything that goes into it: the other's key is part of this step's key.
    kAll,
    // On the bytes of its files only. If the other runs again and writes the same bytes,
    // this step stays finished.
    kFiles,
    // On its being done and having passed its gate. Nothing of it is part of the key.
    kDone,
    // On its results, if it is finished. If both run, the other runs first, but it is not
    // run for this step's sake.
    kShown,
};

struct Need {
    std::string id;  // of the other step
    Use use = Use::kAll;
};

struct StepResult {
    std::vector<std::string> outputs;  // files, relative to the output folder
    Json result = Json::object();      // what the step measured or chose
};

// A unit of work, done once for the same key.
struct Step {
    std::string id;  // "check", "trace overhead"; the user reads it too
    std::vector<Need> needs = {};
    std::uint64_t memory = 0;  // predicted peak, bytes
    // The key of everything else that goes into the step. It is asked for once.
    std::function<Key()> key = {};
    // Does the work. All needs of the step are finished in `graph`.
    std::function<StepResult(Graph& graph)> run = {};
    // Looks at the result, also if the step was finished before. Throws to stop the run.
    std::function<void(const Json& result)> gate = {};
    // Refuses or warns before any work begins, if the step will run.
    std::function<void()> before = {};
    // The files that it will write, as far as their names follow from the scene. Two
    // steps may not write the same file. Throws bad_request as `before` does.
    std::function<std::vector<std::string>()> writes = {};
};

}  // namespace cydonia
