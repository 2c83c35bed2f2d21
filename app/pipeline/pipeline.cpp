#include "app/pipeline/pipeline.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "app/pipeline/manifest.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/output_folder.h"
#include "app/pipeline/steps.h"
#include "app/pipeline/tiles.h"
#include "app/sequence/plan.h"
#include "app/sequence/steps.h"
#include "app/threads.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

struct PlannedStep {
    const Step* step;
    bool is_finished;
};
using Plan = std::vector<PlannedStep>;

// What is left to do for the targets, as far as is known before anything is done. A step
// that needs one that will run is assumed to run too.
Plan plan_of(Graph& graph, const std::vector<std::string>& targets) {
    Plan plan;
    std::set<std::string> to_do;
    for (const Step* step : graph.closure(targets)) {
        const auto runs = [&](const Need& need) { return to_do.contains(need.id); };
        const bool is_finished =
            std::ranges::none_of(step->needs, runs) && graph.finished(step->id);
        if (!is_finished) to_do.insert(step->id);
        plan.push_back({step, is_finished});
    }
    return plan;
}

std::uint64_t predicted_peak(const Plan& plan) {
    std::uint64_t most = 0;
    for (const PlannedStep& p : plan)
        if (!p.is_finished) most = std::max(most, p.step->memory);
    return most;
}

void print(const Plan& plan, const Job& job) {
    fmt::print("{}: {}x{} samples, to {}\n", job.request.scene.string(), job.land.width(),
               job.land.height(), job.folder.string());
    for (const PlannedStep& p : plan) {
        const std::string state =
            p.is_finished ? "done" : "to do, " + bytes_text(p.step->memory);
        const std::string line =
            fmt::format("  {:<24} {:<15} {}", p.step->id, state, needs_text(*p.step));
        fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
    }
    if (job.spec->terrain.tiles > 0) fmt::print("  {}\n", tiles_text(job));
    fmt::print("memory: {} at most, {} available\n", bytes_text(predicted_peak(plan)),
               bytes_text(memory::available()));
}

// Refuses before any work begins whatever can be refused then.
void refuse(const Plan& plan, Graph& graph, Goal goal, const Job& job) {
    memory::refuse_unless_it_fits(predicted_peak(plan), memory::available());
    for (const PlannedStep& p : plan)
        if (!p.is_finished && p.step->before) p.step->before();
    refuse_equal_outputs(graph.closure(names_taken(goal, job)));
}

void carry_out(const std::vector<const Step*>& steps, Graph& graph, Progress& progress) {
    bool is_any_new = false;
    for (const Step* step : steps) {
        if (!graph.finished(step->id)) {
            progress.step(step->id);
            progress.report(0.0);
        }
        const auto [record, is_new] = graph.finish(*step);
        is_any_new |= is_new;
        if (step->gate) step->gate(record.result);
    }
    if (!is_any_new) progress.note("nothing to do: everything is up to date");
}

void write_manifest(Graph& graph, const Job& job) {
    const std::string text = manifest_of(graph, job).dump(2) + "\n";
    const fs::path file = job.folder / "manifest.json";
    if (std::error_code none; fs::exists(file, none) && read_text(file) == text) return;
    write_text(file, text);
}

// Traces frames of a finished land while other processes trace others.
void make_beside_others(const Plan& plan, Graph& graph, Goal goal, const Job& job) {
    const OutputFolder claim(job.folder, OutputFolder::Claim::kShared);
    const std::vector<std::string> own = sequence_targets(*sequence_of(goal), job);
    for (const PlannedStep& p : plan)
        if (!p.is_finished && std::ranges::find(own, p.step->id) == own.end())
            throw bad_request(
                "--trace-only: '{}' has to be done first: cydonia emit with the same "
                "options makes what all frames need",
                p.step->id);
    const auto& frames = *job.request.frames;
    graph.ledger().record_apart(
        fmt::format("{}-{}-{}", name_of(goal), frames.first, frames.last));
    carry_out(graph.closure(targets_of(goal, job)), graph, job.progress);
}

void make_here(const Job& job, Goal goal) {
    check_request(job, goal);
    if (job.request.tile && !job.request.dry_run) return make_tile(job);
    const std::vector<std::string> targets = targets_of(goal, job);
    Ledger ledger(job.folder);
    Graph graph(steps_of(job), ledger);
    const Plan plan = plan_of(graph, targets);
    if (job.request.dry_run) return print(plan, job);
    refuse(plan, graph, goal, job);
    if (job.request.trace_only) return make_beside_others(plan, graph, goal, job);

    const OutputFolder claim(job.folder);
    claim.belongs_to(job.spec->name);
    ledger.reload();  // another process may have worked here until now
    graph.forget();
    try {
        carry_out(graph.closure(targets), graph, job.progress);
    } catch (const Error& error) {
        // The figures are needed most when they fall short.
        if (error.code() == ExitCode::kCheckFellShort) {
            if (std::ranges::find(targets, kReportStep) != targets.end())
                carry_out({&graph.step(kReportStep)}, graph, job.progress);
            write_manifest(graph, job);
        }
        throw;
    }
    write_manifest(graph, job);
}

}  // namespace

void make(const Request& request, Goal goal, Progress& progress) {
    with_threads(request.threads, [&] {
        const Job job(request, progress);
        make_here(job, goal);
    });
}

void make(const Request& request, Goal goal, Console& console) {
    with_threads(request.threads, [&] {
        const Job job(request, console);
        make_here(job, goal);
        if (request.dry_run) return;
        console.finish();
        console.note(fmt::format("in {}", job.folder.string()));
    });
}

}  // namespace cydonia
