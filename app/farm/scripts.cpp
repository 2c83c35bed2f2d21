#include "app/farm/scripts.h"

#include <fmt/core.h>

namespace cydonia {
namespace {

constexpr int kLandMinutes = 240;
constexpr int kTries = 3;

std::string time_text(int minutes) {
    return fmt::format("{}-{:02}:{:02}:00", minutes / 1440, minutes / 60 % 24,
                       minutes % 60);
}

// A quarter more than predicted, because Slurm ends a job that takes more.
std::uint64_t megabytes(std::uint64_t bytes) { return bytes / 4 * 5 / 1000000 + 64; }

// Directives are not read by a shell, so paths in them could not be quoted: logs go to
// the folder that sbatch is run in.
std::string head(const FarmPlan& plan, const std::string& job, const std::string& log,
                 int minutes, std::uint64_t memory) {
    return fmt::format(
        "#!/bin/bash\n"
        "#SBATCH --job-name={}-{}\n"
        "#SBATCH --nodes=1\n"
        "#SBATCH --ntasks=1\n"
        "#SBATCH --time={}\n"
        "#SBATCH --mem={}M\n"
        "#SBATCH --requeue\n"
        "#SBATCH --open-mode=append\n"
        "#SBATCH --output={}\n",
        plan.name, job, time_text(minutes), megabytes(memory), log);
}

std::string command(const FarmPlan& plan, const std::string& name) {
    return fmt::format("{} {} {} -o {}", quoted(plan.program.string()), name,
                       quoted(plan.request.scene.string()),
                       quoted(plan.request.output.string()));
}

std::string options(const Request& request) {
    std::string text = fmt::format(" --quality {}", name_of(request.quality));
    for (const std::string& line : request.overrides) text += " --set " + quoted(line);
    if (request.force) text += " --force";
    return text;
}

// Exit code 1 and signals may not happen again: on another node, or later, it may work.
std::string body(const FarmPlan& plan, const std::string& lines) {
    return fmt::format(
        "\ncd {} || exit 1\n{}\ncode=$?\n"
        "# What failed here may go well on another node: {} tries in all.\n"
        "if (((code == 1 || code > 128) && ${{SLURM_RESTART_COUNT:-0}} < {})); then\n"
        "    scontrol requeue \"$SLURM_JOB_ID\" && sleep 60\n"
        "fi\n"
        "exit \"$code\"\n",
        quoted(plan.folder.string()), lines, kTries, kTries - 1);
}

Script land(const FarmPlan& plan) {
    return {"land.sh", head(plan, "land", "%x-%j.log", kLandMinutes, plan.land_memory) +
                           "#SBATCH --exclusive\n" +
                           body(plan, command(plan, "emit") + options(plan.request))};
}

Script frames(const FarmPlan& plan) {
    std::string chunks;
    for (const Request::Frames& chunk : plan.chunks)
        chunks +=
            fmt::format("{}{}-{}", chunks.empty() ? "" : " ", chunk.first, chunk.last);
    const auto& size = plan.request.size;
    const std::string lines = fmt::format(
        "frames=({})\n{}{}{} \\\n    --threads 1 --trace-only --frames "
        "\"${{frames[SLURM_ARRAY_TASK_ID]}}\"",
        chunks, command(plan, std::string(name_of(plan.goal))), options(plan.request),
        size ? fmt::format(" --size {}x{}", (*size)[0], (*size)[1]) : "");
    return {"frames.sh",
            head(plan, "frames", "%x-%A_%a.log", plan.minutes, plan.frame_memory) +
                fmt::format("#SBATCH --cpus-per-task=1\n#SBATCH --array=0-{}\n",
                            plan.chunks.size() - 1) +
                body(plan, lines)};
}

Script collect(const FarmPlan& plan) {
    return {"collect.sh",
            head(plan, "collect", "%x-%j.log", kLandMinutes, plan.collect_memory) +
                "#SBATCH --exclusive\n" + body(plan, command(plan, "farm collect"))};
}

}  // namespace

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (const char c : word) {
        if (c == '\'')
            text += "'\\''";
        else
            text += c;
    }
    return text + "'";
}

std::vector<Script> scripts_of(const FarmPlan& plan) {
    std::vector<Script> scripts;
    if (plan.land) scripts.push_back(land(plan));
    if (!plan.chunks.empty()) scripts.push_back(frames(plan));
    scripts.push_back(collect(plan));
    return scripts;
}

}  // namespace cydonia
