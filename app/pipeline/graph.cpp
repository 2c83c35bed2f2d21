#include "app/pipeline/graph.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>

#include "field/error.h"

namespace cydonia {
namespace {

// The most memory that this process or one of its child processes has held so far.
std::uint64_t peak_memory() {
    rusage own = {}, children = {};
    getrusage(RUSAGE_SELF, &own);
    getrusage(RUSAGE_CHILDREN, &children);
    return static_cast<std::uint64_t>(std::max(own.ru_maxrss, children.ru_maxrss)) * 1024;
}

// Each step after its needs. Of those that could be next, the first given comes first.
std::vector<Step> in_order(std::vector<Step> steps) {
    std::vector<Step> ordered;
    std::set<std::string> left;
    for (const Step& step : steps) left.insert(step.id);
    while (!steps.empty()) {
        const auto is_ready = [&](const Step& step) {
            return std::ranges::none_of(
                step.needs, [&](const Need& need) { return left.contains(need.id); });
        };
        const auto next = std::ranges::find_if(steps, is_ready);
        if (next == steps.end())
            throw std::logic_error(
                fmt::format("step '{}' needs itself by way of others", steps[0].id));
        left.erase(next->id);
        ordered.push_back(std::move(*next));
        steps.erase(next);
    }
    return ordered;
}

void add_files(KeyBuilder& key, const StepRecord& record) {
    key.add(record.sizes).add(record.hashes);
    // Very large files are not hashed.
    for (std::size_t i = 0; i < record.hashes.size(); ++i)
        if (record.hashes[i] == 0) key.add(record.written[i]);
}

}  // namespace

Graph::Graph(std::vector<Step> steps, Ledger& ledger, Graph* below)
    : ledger_(ledger), below_(below) {
    std::set<std::string> ids;
    for (const Step& step : steps)
        if (!ids.insert(step.id).second)
            throw std::logic_error(fmt::format("two steps are called '{}'", step.id));
    for (const Step& step : steps)
        for (const Need& need : step.needs)
            if (!ids.contains(need.id) && !(below_ && below_->index_.contains(need.id)))
                throw std::logic_error(fmt::format(
                    "step '{}' needs '{}', which is no step", step.id, need.id));
    steps_ = in_order(std::move(steps));
    for (std::size_t i = 0; i < steps_.size(); ++i) index_[steps_[i].id] = i;
}

const Step& Graph::step(const std::string& id) const { return steps_[index_.at(id)]; }

std::vector<const Step*> Graph::closure(const std::vector<std::string>& targets) const {
    std::set<std::string> wanted(targets.begin(), targets.end());
    // Backwards, because all needs of a step come before it.
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
        if (!wanted.contains(step->id)) continue;
        for (const Need& need : step->needs)
            if (need.use != Use::kShown) wanted.insert(need.id);
    }
    std::vector<const Step*> closure;
    for (const Step& step : steps_)
        if (wanted.contains(step.id)) closure.push_back(&step);
    return closure;
}

const StepRecord* Graph::finished(const std::string& id) {
    const auto here = index_.find(id);
    if (here == index_.end()) return below_->finished(id);
    const std::scoped_lock lock(mutex_);
    return finished_here(steps_[here->second]);
}

const StepRecord* Graph::finished_here(const Step& step) {
    if (const auto known = finished_.find(step.id); known != finished_.end())
        return known->second;
    // Some keys take time to find, so a step that never ran is not asked for its key.
    if (!ledger_.has(step.id)) return nullptr;
    for (const Need& need : step.needs) {
        if (need.use == Use::kShown) continue;
        const auto here = index_.find(need.id);
        if (!(here == index_.end() ? below_->finished(need.id)
                                   : finished_here(steps_[here->second])))
            return nullptr;
    }
    const StepRecord* record = ledger_.finished(step.id, key(step).value());
    if (record) finished_[step.id] = record;
    return record;
}

// None while a step that goes into it is not finished.
std::optional<Key> Graph::key(const Step& step) {
    if (const auto known = keys_.find(step.id); known != keys_.end())
        return known->second;
    if (!own_keys_.contains(step.id)) own_keys_[step.id] = step.key();
    KeyBuilder builder("step");
    builder.add(own_keys_.at(step.id));
    for (const Need& need : step.needs) {
        if (need.use == Use::kDone) continue;
        const auto here = index_.find(need.id);
        const StepRecord* record = here == index_.end()
                                       ? below_->finished(need.id)
                                       : finished_here(steps_[here->second]);
        if (!record && need.use == Use::kShown) continue;
        if (!record) return std::nullopt;
        if (need.use != Use::kFiles) builder.add(need.id).add(record->key);
        if (need.use != Use::kAll) add_files(builder, *record);
    }
    // A step that is shown may still be finished later, which changes the key.
    const bool is_settled = std::ranges::none_of(
        step.needs, [](const Need& need) { return need.use == Use::kShown; });
    if (is_settled) keys_[step.id] = builder.key();
    return builder.key();
}

Graph::Outcome Graph::finish(const Step& step) {
    if (const StepRecord* record = finished(step.id)) return {*record, false};
    std::optional<Key> known;
    {
        const std::scoped_lock lock(mutex_);
        known = key(step);
    }
    if (!known)
        throw std::logic_error(
            fmt::format("step '{}' is to run before what it needs", step.id));
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    StepResult made = step.run(*this);
    const std::chrono::duration<double> seconds = Clock::now() - begin;
    const StepRecord& record =
        ledger_.record(step.id, {.key = *known,
                                 .outputs = std::move(made.outputs),
                                 .result = std::move(made.result),
                                 .seconds = seconds.count(),
                                 .peak_memory = peak_memory()});
    const std::scoped_lock lock(mutex_);
    finished_[step.id] = &record;
    return {record, true};
}

void Graph::forget() {
    const std::scoped_lock lock(mutex_);
    keys_.clear();
    finished_.clear();
}

void refuse_equal_outputs(const std::vector<const Step*>& steps) {
    std::map<std::string, const Step*> writers;
    for (const Step* step : steps) {
        if (!step->writes) continue;
        for (const std::string& file : step->writes()) {
            const auto [first, is_new] = writers.emplace(file, step);
            if (is_new) continue;
            const Step* other = first->second;
            throw bad_request(
                "{} would be written twice, by '{}' and by '{}'; rename the "
                "camera that one of them is called after",
                file, other->id, step->id);
        }
    }
}

std::string needs_text(const Step& step) {
    std::string text;
    const auto add = [&](Use use, const char* how) {
        std::string ids;
        for (const Need& need : step.needs)
            if (need.use == use) ids += (ids.empty() ? "" : ", ") + need.id;
        if (!ids.empty()) text += (text.empty() ? "" : "; ") + std::string(how) + ids;
    };
    add(Use::kAll, "from ");
    add(Use::kFiles, "the files of ");
    add(Use::kDone, "after ");
    const auto is_shown = [](const Need& need) { return need.use == Use::kShown; };
    if (std::ranges::any_of(step.needs, is_shown)) text += "shows what is finished";
    return text;
}

}  // namespace cydonia
