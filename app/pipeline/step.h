#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/pipeline/key.h"
#include "app/pipeline/ledger.h"

namespace cydonia {

class Graph;

// What a step makes of another one.
enum class Use {
    // Everything: the other's key is part of this step's.
    kAll,
    // The bytes of its files, nothing else: when the other is done again and they come
    // out the same, this step stays finished.
    kFiles,
    // Only that it is done and its gate has let the run pass.
    kDone,
    // Shows the other where it is finished, and runs behind it where both run. Unlike the
    // rest, the other is not done for this step's sake.
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

// One unit of work: run at most once for the same key.
struct Step {
    std::string id;  // "check", "trace overhead": also what the user reads
    std::vector<Need> needs = {};
    std::uint64_t memory = 0;  // predicted peak, bytes
    // Of all that goes in besides what the needs bring. Asked once.
    std::function<Key()> key = {};
    // The graph holds the step's needs, finished.
    std::function<StepResult(Graph& graph)> run = {};
    // Looks at the result, also of a step that was finished before, and throws to stop
    // the run here.
    std::function<void(const Json& result)> gate = {};
    // Refuses or warns before any work begins; asked only of a step that will run.
    std::function<void()> before = {};
    // The files that it will write, as far as their names follow from the scene: no
    // other step may write them too. Throws bad_request as `before` does.
    std::function<std::vector<std::string>()> writes = {};
};

}  // namespace cydonia
