#include "app/pipeline/pipeline.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <span>

#include "app/pipeline/job.h"
#include "app/pipeline/manifest.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/output_folder.h"
#include "app/pipeline/tiles.h"
#include "app/threads.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// The most memory this process or a program it ran has held so far.
std::uint64_t peak_memory() {
    rusage own = {}, children = {};
    getrusage(RUSAGE_SELF, &own);
    getrusage(RUSAGE_CHILDREN, &children);
    return static_cast<std::uint64_t>(std::max(own.ru_maxrss, children.ru_maxrss)) * 1024;
}

const Entry& carry_out(const Step& step, std::uint64_t key, Job& job) {
    using Clock = std::chrono::steady_clock;
    job.progress.step(step.name);
    const Clock::time_point begin = Clock::now();
    job.progress.report(0.0);
    Made made = step.run();
    const std::chrono::duration<double> seconds = Clock::now() - begin;
    return job.ledger.record(step.name, {key,
                                         std::move(made.outputs),
                                         {},
                                         std::move(made.result),
                                         seconds.count(),
                                         peak_memory()});
}

struct PlannedStep {
    const Step* step;
    bool finished;
};

// Sequences film frames of their own and leave the stills alone.
bool is_for(const Step& step, Goal goal) {
    return step.goal == goal || step.goal < (goal > Goal::kFrames ? Goal::kEmit : goal);
}

// What is left to do for a goal, as far as it can be told before anything is done: a step
// after one that will run is taken to run as well.
std::vector<PlannedStep> plan_of(const std::vector<Step>& steps, Goal goal,
                                 const Ledger& ledger) {
    std::vector<PlannedStep> plan;
    bool all_before_finished = true;
    for (const Step& step : steps) {
        if (!is_for(step, goal)) continue;
        const bool finished =
            all_before_finished && ledger.finished(step.name, step.key());
        plan.push_back({&step, finished});
        all_before_finished = finished;
    }
    return plan;
}

std::uint64_t predicted_peak(const std::vector<PlannedStep>& plan) {
    std::uint64_t most = 0;
    for (const PlannedStep& p : plan) {
        if (!p.finished) most = std::max(most, p.step->memory);
    }
    return most;
}

void print_plan(const std::vector<PlannedStep>& plan, const Job& job) {
    fmt::print("{}: {}x{} samples, to {}\n", job.request.scene.string(), job.land.width(),
               job.land.height(), job.folder.string());
    for (const PlannedStep& p : plan) {
        fmt::print("  {:<24} {}\n", p.step->name,
                   p.finished ? "done" : "to do " + bytes_text(p.step->memory));
    }
    if (job.spec.terrain.tiles > 0) fmt::print("  {}\n", tiles_text(job));
    fmt::print("memory: {} at most, {} available\n", bytes_text(predicted_peak(plan)),
               bytes_text(memory::available()));
}

void carry_out(std::span<const Step> steps, Goal goal, Job& job) {
    int done = 0;
    for (const Step& step : steps) {
        if (!is_for(step, goal)) continue;
        const std::uint64_t key = step.key();
        const Entry* entry = job.ledger.finished(step.name, key);
        if (!entry) {
            entry = &carry_out(step, key, job);
            ++done;
        }
        if (step.gate) step.gate(entry->result);
    }
    if (done == 0) job.progress.note("nothing to do: everything is up to date");
}

void write_manifest(const std::vector<Step>& steps, const Job& job) {
    const std::string text = manifest_of(steps, job).dump(2) + "\n";
    const fs::path file = job.folder / "manifest.json";
    if (std::error_code none; fs::exists(file, none) && read_text(file) == text) return;
    write_text(file, text);
}

// Frames of a land that is made, beside others who do the same.
void make_beside_others(const std::vector<PlannedStep>& plan, Goal goal, Job& job) {
    const OutputFolder claim(job.folder, OutputFolder::Claim::kShared);
    std::vector<Step> own;
    for (const PlannedStep& p : plan) {
        if (p.step->goal == Goal::kReport) continue;
        own.push_back(*p.step);
        if (!p.finished && p.step->goal != goal)
            throw bad_request(
                "--trace-only: '{}' is to be done first: cydonia emit with the same "
                "options makes what all frames need",
                p.step->name);
    }
    const auto& frames = *job.request.frames;
    job.ledger.record_apart(
        fmt::format("{}-{}-{}", name_of(goal), frames.first, frames.last));
    carry_out(own, goal, job);
}

void make_here(Job& job, Goal goal) {
    check_request(job, goal);
    if (job.request.tile && !job.request.dry_run) return make_tile(job);
    const std::vector<Step> steps = steps_of(job);
    const std::vector<PlannedStep> plan = plan_of(steps, goal, job.ledger);
    if (job.request.dry_run) return print_plan(plan, job);

    // Whatever can be refused is refused before any work begins.
    memory::refuse_unless_it_fits(predicted_peak(plan), memory::available());
    for (const PlannedStep& p : plan) {
        if (!p.finished && p.step->before) p.step->before();
    }
    if (job.request.trace_only) return make_beside_others(plan, goal, job);
    const OutputFolder claim(job.folder);
    job.ledger = Ledger(job.folder);  // another may have been at work until now
    claim.belongs_to(job.spec.name);

    try {
        carry_out(steps, goal, job);
    } catch (const Error& error) {
        // What was measured is most wanted when it fell short.
        if (error.code() == ExitCode::kCheckFellShort) {
            if (Goal::kReport <= goal) carry_out({&steps.back(), 1}, goal, job);
            write_manifest(steps, job);
        }
        throw;
    }
    write_manifest(steps, job);
}

}  // namespace

void make(const Request& request, Goal goal, Progress& progress) {
    with_threads(request.threads, [&] {
        Job job(request, progress);
        make_here(job, goal);
    });
}

void make(const Request& request, Goal goal, Console& console) {
    with_threads(request.threads, [&] {
        Job job(request, console);
        make_here(job, goal);
        if (request.dry_run) return;
        console.finish();
        console.note(fmt::format("in {}", job.folder.string()));
    });
}

}  // namespace cydonia
