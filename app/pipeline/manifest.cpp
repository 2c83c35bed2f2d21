#include "app/pipeline/manifest.h"

#include <algorithm>
#include <optional>

#include "app/request_json.h"

namespace cydonia {
namespace {

// Relative to the output folder, so that both can be moved together.
std::string path_to(const std::filesystem::path& file, const Job& job) {
    return std::filesystem::proximate(file, std::filesystem::absolute(job.folder))
        .generic_string();
}

Json json_of(const Source& source, const Job& job) {
    return {{"file", source.name()},
            {"path", path_to(source.path, job)},
            {"bytes", source.size},
            {"xxh3", hex(source.hash)}};
}

Json inputs_of(const Job& job) {
    Json inputs = {{"scene", json_of(job.scene_file, job)},
                   {"set", job.request.overrides},
                   {"files", Json::array()}};
    const auto add = [&](const Source& source) {
        inputs["files"].push_back(json_of(source, job));
    };
    for (const config::StageSpec& stage : job.spec.stages)
        std::ranges::for_each(stage.sources, add);
    if (job.spec.render.colour.config) add(*job.spec.render.colour.config);
    return inputs;
}

Json versions_of(const Job& job) {
    Json versions = {{"cydonia", kVersion}, {"program", hex(job.program)}};
    for (const config::StageSpec& stage : job.spec.stages) {
        const Method method = method_of(stage.options);
        versions[std::string(method.name)] = method.version;
    }
    return versions;
}

// The finished steps as they are now. Frames are made from what steps before them wrote:
// after one that is to be done again, they do not count.
std::vector<const Step*> finished_steps(const std::vector<Step>& steps, const Job& job) {
    std::vector<const Step*> finished;
    bool assets = true, emitted = true;
    for (const Step& step : steps) {
        const bool is_one = job.ledger.finished(step.name, step.key()) != nullptr;
        if (step.goal <= Goal::kAssets && step.goal != Goal::kReport) assets &= is_one;
        if (step.goal <= Goal::kEmit && step.goal != Goal::kReport) emitted &= is_one;
        const bool counts = step.goal <= Goal::kReport  ? true
                            : step.goal > Goal::kFrames ? assets
                                                        : emitted;
        if (is_one && counts) finished.push_back(&step);
    }
    return finished;
}

// The farthest of the stills' goals, which includes those before it, and every film.
std::vector<Goal> goals_of(const std::vector<Step>& steps,
                           const std::vector<const Step*>& finished) {
    std::vector<Goal> goals;
    std::optional<Goal> still;
    for (const Goal goal : {Goal::kTerrain, Goal::kCheck, Goal::kEmit, Goal::kFrames,
                            Goal::kSweep, Goal::kTurntable, Goal::kFilm}) {
        const auto of_goal = [goal](const Step& step) { return step.goal == goal; };
        if (std::ranges::none_of(steps, of_goal) ||
            !std::ranges::all_of(steps, [&](const Step& step) {
                return !of_goal(step) ||
                       std::ranges::find(finished, &step) != finished.end();
            }))
            continue;
        if (goal <= Goal::kFrames)
            still = goal;
        else
            goals.push_back(goal);
    }
    if (still) goals.insert(goals.begin(), *still);
    return goals;
}

Json land_of(const Job& job) {
    const Land& land = job.land;
    return {{"samples", {land.width(), land.height()}},
            {"spacing", land.spacing()},
            {"extent", {land.spacing() * land.width(), land.spacing() * land.height()}},
            {"axes", {{"east", "x"}, {"north", "y"}, {"up", "z"}}},
            {"origin", "the south-western corner of the extent, at height 0"},
            {"rows", "from north to south"},
            {"unit", "metre"},
            {"drawn_factor", land.factor()}};
}

void add_outputs(Json& manifest, const Step& step, const Entry& entry) {
    for (std::size_t i = 0; i < entry.outputs.size(); ++i)
        manifest["outputs"].push_back({{"file", entry.outputs[i]},
                                       {"step", step.name},
                                       {"bytes", entry.sizes[i]},
                                       {"xxh3", hex(entry.hashes[i])}});
}

}  // namespace

Json options_of(const config::SceneSpec& spec) {
    Json stages = Json::array();
    for (const config::StageSpec& stage : spec.stages)
        stages.push_back(
            {{"method", method_of(stage.options).name}, {"text", stage.text}});
    return {{"extent", {spec.terrain.width, spec.terrain.depth}},
            {"samples", spec.terrain.samples},
            {"tiles", spec.terrain.tiles},
            {"stages", stages},
            {"render", spec.render_text},
            {"frames", spec.frames_text}};
}

Json manifest_of(const std::vector<Step>& steps, const Job& job) {
    const auto finished = finished_steps(steps, job);
    Json manifest = {
        {"manifest", kManifestVersion},
        {"title", job.spec.title},
        {"scene", job.spec.name},
        {"seed", job.spec.seed},
        {"quality", name_of(job.request.quality)},
        {"command", json_of(Command{goals_of(steps, finished), job.request})},
        {"versions", versions_of(job)},
        {"inputs", inputs_of(job)},
        {"options", options_of(job.spec)},
        {"land", land_of(job)},
        {"figures", Json::object()},
        {"outputs", Json::array()}};
    Json timings = {{"threads", job.request.threads}, {"seconds", Json::object()}};
    std::uint64_t peak = 0;
    for (const Step* step : finished) {
        const Entry& entry = *job.ledger.finished(step->name, step->key());
        if (!entry.result.empty()) manifest["figures"][step->name] = entry.result;
        add_outputs(manifest, *step, entry);
        timings["seconds"][step->name] = entry.seconds;
        peak = std::max(peak, entry.peak_memory);
    }
    timings["peak_memory"] = peak;
    manifest["timings"] = timings;
    return manifest;
}

}  // namespace cydonia
