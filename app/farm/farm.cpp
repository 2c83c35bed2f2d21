#include "app/farm/farm.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "app/farm/record.h"
#include "app/farm/scripts.h"
#include "app/farm/slurm.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/pipeline.h"
#include "app/pipeline/steps.h"
#include "app/sequence/filming.h"
#include "app/sequence/plan.h"
#include "app/sequence/steps.h"
#include "app/threads.h"
#include "field/error.h"
#include "field/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr std::size_t kMostTasks = 1000;  // of an array: Slurm's default limit

Kind kind_of(const FarmRequest& asked, const Job& job) {
    if (asked.sequence) return *asked.sequence;
    const auto flies = [](const render::CameraOptions& camera) {
        return camera.kind == render::CameraOptions::Kind::kPath;
    };
    const bool moves =
        job.scene.varies() || std::ranges::any_of(job.spec->render.cameras, flies);
    return moves ? Kind::kFilm : Kind::kTurntable;
}

// Frames of a task. A node that dies loses at most these; each start is worth its time.
int chunk_of(render::Quality quality) {
    constexpr int kFrames[] = {8, 4, 1};
    return kFrames[static_cast<int>(quality)];
}

int minutes_of(render::Quality quality, int chunk) {
    constexpr int kMinutes[] = {5, 30, 240};  // for a frame on one core
    return chunk * kMinutes[static_cast<int>(quality)];
}

// Ranges of consecutive frames, at most `chunk` in each.
std::vector<Request::Frames> chunks_of(const std::vector<std::size_t>& frames,
                                       int chunk) {
    std::vector<Request::Frames> chunks;
    for (const std::size_t index : frames) {
        const int frame = static_cast<int>(index);
        const bool goes_on = !chunks.empty() && chunks.back().last + 1 == frame &&
                             frame - chunks.back().first < chunk;
        if (goes_on)
            chunks.back().last = frame;
        else
            chunks.push_back({frame, frame});
    }
    return chunks;
}

// Whether everything that frames are traced from is finished.
bool has_land(Graph& graph) {
    return graph.finished(kAssetsStep) && graph.finished(kExportStep);
}

std::uint64_t most_memory(const std::vector<const Step*>& steps) {
    std::uint64_t most = 0;
    for (const Step* step : steps) most = std::max(most, step->memory);
    return most;
}

// The frames that are not traced yet. Before the land is made that is all of them, and
// the suns of a day are not known.
std::vector<std::size_t> missing(Kind kind, int count, const Job& job, Graph& graph) {
    if (has_land(graph)) return frames_to_trace(job, plan_of(kind, job).sequence, graph);
    if (kind != Kind::kDay) {
        const Sequence sequence = plan_of(kind, job).sequence;
        auto frames = frames_to_make(sequence, job.request);
        frames.insert(frames.end(), sequence.exposed_by.begin(),
                      sequence.exposed_by.end());
        std::ranges::sort(frames);
        frames.erase(std::ranges::unique(frames).begin(), frames.end());
        return frames;
    }
    if (job.request.frames)
        throw bad_request(
            "a part of a day needs the land first, on which the sun depends: cydonia "
            "emit "
            "with the same options makes it");
    std::vector<std::size_t> all(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
}

// The request for other machines and later commands: with absolute paths, and with the
// number of frames.
Request settled(Request request, const Job& job, Kind kind, int count) {
    request.scene = fs::absolute(request.scene).lexically_normal();
    request.output = fs::absolute(job.folder).lexically_normal();
    request.quiet = request.dry_run = false;
    if (request.frames && request.frames->first == 0 && request.frames->last + 1 == count)
        request.frames.reset();
    if (!job.spec->frames.count && kind != Kind::kFilm)
        request.overrides.push_back(fmt::format("frames.count={}", count));
    return request;
}

void refuse_while_queued(const fs::path& output) {
    if (!has_record(output)) return;
    const FarmRecord record = read_record(output);
    if (std::ranges::any_of(slurm::tasks_of(record.ids()), &slurm::Task::is_queued))
        throw bad_request(
            "jobs that were submitted before are still queued: see cydonia farm status, "
            "or "
            "cancel them with scancel {}",
            fmt::join(record.ids(), " "));
}

void print(const std::vector<Script>& scripts, const FarmPlan& plan) {
    const fs::path folder = farm_folder(plan.request.output);
    for (const Script& script : scripts)
        fmt::print("# {}\n{}\n", (folder / script.file).string(), script.text);
    fmt::print("# To be submitted from {}, each after the one before:\n",
               quoted(folder.string()));
    for (const Script& script : scripts)
        fmt::print(
            "# sbatch {}{}\n",
            &script == &scripts.front() ? "" : "--dependency=afterok:<the last's id> ",
            script.file);
}

// Submits all scripts or none: after a refusal the jobs submitted before are cancelled.
void submit_all(const std::vector<Script>& scripts, const FarmPlan& plan) {
    const fs::path folder = farm_folder(plan.request.output);
    make_folder(folder);
    FarmRecord record{plan.request, plan.goal, {}};
    for (const Script& script : scripts) write_text(folder / script.file, script.text);
    try {
        std::vector<std::string> after;
        for (const Script& script : scripts) {
            const std::string id = slurm::submit(script.file, folder, after);
            record.jobs.emplace_back(fs::path(script.file).stem().string(), id);
            after = {id};
        }
        write_record(record, plan.request.output);
    } catch (...) {
        slurm::cancel(record.ids());
        throw;
    }
}

FarmPlan farm_plan(const FarmRequest& asked, const Job& job) {
    const Kind kind = kind_of(asked, job);
    const int count = check_plan(kind, job);
    Ledger ledger(job.folder);
    Graph graph(steps_of(job), ledger);
    refuse_equal_outputs(graph.closure(names_taken(goal_of(kind), job)));

    FarmPlan plan;
    plan.program = fs::read_symlink("/proc/self/exe");
    plan.folder = fs::current_path();
    plan.name = job.spec->name;
    plan.goal = goal_of(kind);
    plan.land = !has_land(graph);
    const auto frames = missing(kind, count, job, graph);
    const int chunk =
        std::max(asked.chunk.value_or(chunk_of(job.request.quality)),
                 static_cast<int>((frames.size() + kMostTasks - 1) / kMostTasks));
    plan.chunks = chunks_of(frames, chunk);
    if (plan.chunks.size() > kMostTasks)
        throw bad_request(
            "{} ranges of missing frames are more than the {} tasks of an array",
            plan.chunks.size(), kMostTasks);
    plan.minutes = asked.minutes.value_or(minutes_of(job.request.quality, chunk));
    plan.land_memory = most_memory(graph.closure(targets_of(Goal::kEmit, job)));
    // This program's memory and POV-Ray's at the same time.
    plan.frame_memory = memory::of_emit(job.drawn_cells());
    std::uint64_t own = 0;
    for (const std::string& id : sequence_targets(kind, job))
        own = std::max(own, graph.step(id).memory);
    plan.frame_memory += own;
    plan.collect_memory = most_memory(graph.closure(targets_of(plan.goal, job)));
    plan.request = settled(asked.request, job, kind, count);
    return plan;
}

// The request of a farm's record, for the scene and folder of this one.
Request recorded(const Request& request, const FarmRecord& record,
                 const fs::path& output) {
    Request all = record.request;
    all.scene = request.scene;
    all.output = output;
    all.quiet = request.quiet;
    return all;
}

std::vector<std::size_t> still_missing(const Request& request, Goal goal,
                                       Console& console) {
    std::vector<std::size_t> frames;
    with_threads(request.threads, [&] {
        const Job job(request, console);
        const Kind kind = sequence_of(goal).value();
        const int count = check_plan(kind, job);
        Ledger ledger(job.folder);
        Graph graph(steps_of(job), ledger);
        frames = missing(kind, count, job, graph);
    });
    return frames;
}

// "done", "waits (Dependency)", "runs on n1, n2; 3 wait; 1 failed: 13_4 (TIMEOUT)".
std::string state_of(const std::vector<slurm::Task>& tasks, const std::string& id) {
    std::vector<std::string> nodes, failed;
    std::string reason;
    int waiting = 0, done = 0;
    for (const slurm::Task& task : tasks) {
        if (!task.of(id)) continue;
        if (task.has_failed()) {
            failed.push_back(fmt::format("{} ({})", task.job, task.state));
        } else if (!task.is_queued()) {
            ++done;
        } else if (!task.node.empty()) {
            nodes.push_back(task.node);
        } else {
            ++waiting;
            reason = task.reason;
        }
    }
    std::vector<std::string> parts;
    if (!nodes.empty()) {
        std::ranges::sort(nodes);
        nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
        parts.push_back(fmt::format("runs on {}", fmt::join(nodes, ", ")));
    }
    if (waiting > 0) parts.push_back(fmt::format("{} waiting ({})", waiting, reason));
    if (!failed.empty())
        parts.push_back(
            fmt::format("{} failed: {}", failed.size(), fmt::join(failed, ", ")));
    if (parts.empty()) return done > 0 ? "done" : "no longer in the queue";
    return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

void farm(const FarmRequest& asked, Console& console) {
    with_threads(asked.request.threads, [&] {
        const Job job(asked.request, console);
        const FarmPlan plan = farm_plan(asked, job);
        const std::vector<Script> scripts = scripts_of(plan);
        if (asked.request.dry_run) return print(scripts, plan);
        refuse_while_queued(plan.request.output);
        submit_all(scripts, plan);
        const FarmRecord record = read_record(plan.request.output);
        std::vector<std::string> jobs;
        for (const auto& [what, id] : record.jobs)
            jobs.push_back(fmt::format("{} {}", what, id));
        console.note(fmt::format("{} submitted: jobs {}", name_of(plan.goal),
                                 fmt::join(jobs, ", ")));
        console.note(fmt::format("logs in {}; cydonia farm status {} shows the progress",
                                 farm_folder(job.folder).string(),
                                 asked.request.scene.string()));
    });
}

void farm_status(const Request& request, Console& console) {
    const fs::path output = output_of(request);
    const FarmRecord record = read_record(output);
    const Request all = recorded(request, record, output);
    const auto left = still_missing(all, record.goal, console);
    const auto tasks = slurm::tasks_of(record.ids());
    for (const auto& [what, id] : record.jobs)
        fmt::print("{:<8} job {:<8} {}\n", what, id, state_of(tasks, id));
    fmt::print("frames still to be traced: {}\n", left.size());
    const bool queued = std::ranges::any_of(tasks, &slurm::Task::is_queued);
    if (!queued && !left.empty())
        fmt::print(
            "the same cydonia farm command submits what is missing; logs are in {}\n",
            farm_folder(output).string());
}

void farm_collect(const Request& request, Console& console) {
    const fs::path output = output_of(request);
    const FarmRecord record = read_record(output);
    const Request all = recorded(request, record, output);
    if (const auto left = still_missing(all, record.goal, console); !left.empty())
        throw failure(
            "{} frames are not traced, the first is {}: the same cydonia farm command "
            "submits them again",
            left.size(), left.front());
    make(all, record.goal, console);
}

}  // namespace cydonia
