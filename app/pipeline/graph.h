#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/step.h"

namespace cydonia {

// Steps in the order in which they can run, their keys, and which of them are finished.
// Any thread may ask; each step is run by one.
class Graph {
  public:
    // Steps may also need those of `below`, which must outlive this graph. Throws
    // std::logic_error for two steps of one id, a need that no step meets, and needs that
    // go in a circle.
    Graph(std::vector<Step> steps, Ledger& ledger, Graph* below = nullptr);
    Graph(const Graph&) = delete;
    Graph& operator=(const Graph&) = delete;

    // Each behind all that it needs, otherwise as they were given.
    const std::vector<Step>& steps() const { return steps_; }
    const Step& step(const std::string& id) const;
    Ledger& ledger() const { return ledger_; }

    // The targets and everything that must be done for them, in order.
    std::vector<const Step*> closure(const std::vector<std::string>& targets) const;

    // The step's record if it, and all that must be done for it, is finished.
    const StepRecord* finished(const std::string& id);

    // Runs the step unless it is finished. What it needs must be finished.
    struct Outcome {
        const StepRecord& record;
        bool is_new;
    };
    Outcome finish(const Step& step);

    // Looks anew at what is finished: the ledger was read again.
    void forget();

  private:
    const StepRecord* finished_here(const Step& step);
    std::optional<Key> key(const Step& step);

    std::vector<Step> steps_;
    std::map<std::string, std::size_t> index_;
    Ledger& ledger_;
    Graph* below_;

    std::mutex mutex_;                     // of what follows
    std::map<std::string, Key> own_keys_;  // as the steps gave them
    std::map<std::string, Key> keys_;      // with those of their needs
    std::map<std::string, const StepRecord*> finished_;
};

// Throws bad_request, with the names of both steps, where two of them write one file.
void refuse_equal_outputs(const std::vector<const Step*>& steps);

// "from 1 distance; the files of emit land; after check".
std::string needs_text(const Step& step);

}  // namespace cydonia
