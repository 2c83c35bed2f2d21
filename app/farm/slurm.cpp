#include "app/farm/slurm.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <sstream>
#include <string_view>

#include "app/interrupt.h"
#include "field/error.h"
#include "field/progress.h"
#include "render/frames/child.h"
#include "render/frames/program.h"

namespace fs = std::filesystem;

namespace cydonia::slurm {
namespace {

constexpr std::chrono::seconds kTimeLimit{120};  // the controller may be slow to answer
constexpr std::size_t kMostOutput = 64u << 20;

struct Answer {
    int outcome = 0;
    std::string text;
};

std::string trimmed(std::string text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.pop_back();
    return text;
}

Answer ask(const char* name, const std::vector<std::string>& arguments,
           const fs::path& folder) {
    const auto program = render::program_on_path(name);
    if (!program)
        throw failure(
            "no {} on the PATH: the farm is Slurm's, run this where its programs are "
            "(package slurm-client); --dry-run prints what would be submitted",
            name);
    Answer answer;
    const auto outcome = render::outcome_of(
        *program, arguments, folder, kTimeLimit, [&](std::string& output) {
            if (interrupt_signal() != 0) throw Interrupted{};
            if (output.size() > kMostOutput)
                throw failure("{} does not stop answering", name);
            answer.text = output;
        });
    if (!outcome)
        throw failure("{} gave no answer within {} s: is Slurm's controller up?", name,
                      kTimeLimit.count());
    answer.outcome = *outcome;
    answer.text = trimmed(std::move(answer.text));
    return answer;
}

// From the last line, "12" or "12;cluster". Lines before it are advice.
std::string id_in(const std::string& text) {
    const std::string line = text.substr(text.rfind('\n') + 1);
    const std::string id = line.substr(0, line.find(';'));
    if (id.empty() ||
        !std::ranges::all_of(id, [](char c) { return '0' <= c && c <= '9'; }))
        throw failure("sbatch gave no job id: {}", text);
    return id;
}

}  // namespace

std::string submit(const fs::path& script, const fs::path& folder,
                   const std::vector<std::string>& after) {
    std::vector<std::string> arguments{"--parsable"};
    if (!after.empty()) {
        arguments.push_back(
            fmt::format("--dependency=afterok:{}", fmt::join(after, ":")));
        arguments.push_back("--kill-on-invalid-dep=yes");
    }
    arguments.push_back(script.string());
    const Answer answer = ask("sbatch", arguments, folder);
    if (answer.outcome != 0)
        throw failure(
            "sbatch refuses {}: {}; what it asks for is at the script's head, and "
            "Slurm's "
            "own variables (SBATCH_PARTITION, SBATCH_ACCOUNT, SBATCH_TIMELIMIT ...) "
            "change "
            "it",
            script.filename().string(), answer.text);
    return id_in(answer.text);
}

void cancel(const std::vector<std::string>& jobs) {
    if (!jobs.empty()) ask("scancel", jobs, ".");
}

bool Task::of(const std::string& id) const {
    return job == id || job.starts_with(id + "_");
}

bool Task::is_queued() const {
    constexpr std::array<std::string_view, 8> kQueued = {
        "PENDING",   "RUNNING",  "CONFIGURING",  "COMPLETING",
        "SUSPENDED", "REQUEUED", "REQUEUE_HOLD", "STAGE_OUT"};
    return std::ranges::find(kQueued, state) != kQueued.end();
}

bool Task::has_failed() const { return !is_queued() && state != "COMPLETED"; }

std::vector<Task> tasks_of(const std::vector<std::string>& jobs) {
    if (jobs.empty()) return {};
    const Answer answer =
        ask("squeue",
            {"--noheader", "--states=all", "--array", "--format=%i|%T|%N|%r",
             fmt::format("--jobs={}", fmt::join(jobs, ","))},
            ".");
    if (answer.outcome != 0) {
        // Slurm no longer knows jobs that ended long ago.
        if (answer.text.find("Invalid job id") != answer.text.npos) return {};
        throw failure("squeue: {}", answer.text);
    }
    std::vector<Task> tasks;
    std::istringstream lines(answer.text);
    for (std::string line; std::getline(lines, line);) {
        std::array<std::string, 4> part;
        std::istringstream in(line);
        for (std::string& text : part) std::getline(in, text, '|');
        if (!part[1].empty())
            tasks.push_back({part[0], part[1], trimmed(part[2]), trimmed(part[3])});
    }
    return tasks;
}

}  // namespace cydonia::slurm
