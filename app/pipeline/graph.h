#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline/step.h"

namespace cydonia {

// Steps in an order in which they can run, with their keys and which of them are
// finished. Any thread may ask; a step is run by one thread.
class Graph {
  public:
    // Steps may also need steps of `below`, which must outlive this graph. Throws
    // std::logic_error for two steps with the same id, unknown needs and circular needs.
    Graph(std::vector<Step> steps, Ledger& ledger, Graph* below = nullptr);
    Graph(const Graph&) = delete;
    Graph& operator=(const Graph&) = delete;

    // Each step comes after all that it needs; otherwise in the order given.
    const std::vector<Step>& steps() const { return steps_; }
    const Step& step(const std::string& id) const;
    Ledger& ledger() const { return ledger_; }

    // The targets and all steps that must be done for them, in order.
    std::vector<const Step*> closure(const std::vector<std::string>& targets) const;

    // The step's record if it and all steps that must be done for it are finished.
    const StepRecord* finished(const std::string& id);

    // Runs the step unless it is finished. All its needs must be finished.
    struct Outcome {
        const StepRecord& record;
        bool is_new;
    };
    Outcome finish(const Step& step);

    // Checks again what is finished, after the ledger was reloaded.
    void forget();

  private:
    const StepRecord* finished_here(const Step& step);
    std::optional<Key> key(const Step& step);

    std::vector<Step> steps_;
    std::map<std::string, std::size_t> index_;
    Ledger& ledger_;
    Graph* below_;

    std::mutex mutex_;                     // guards what follows
    std::map<std::string, Key> own_keys_;  // Step::key()
    std::map<std::string, Key> keys_;      // with the needs
    std::map<std::string, const StepRecord*> finished_;
};

// Throws bad_request naming both steps if two of them write the same file.
void refuse_equal_outputs(const std::vector<const Step*>& steps);

// "from 1 distance; the files of emit land; after check".
std::string needs_text(const Step& step);

}  // namespace cydonia
