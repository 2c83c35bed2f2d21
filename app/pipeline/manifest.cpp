#include "app/pipeline/manifest.h"

#include <algorithm>
#include <iterator>

#include "app/request_json.h"

namespace cydonia {
namespace {

// The path relative to the output folder, so that both can be moved together.
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
    for (const config::StageSpec& stage : job.spec->stages)
        std::ranges::for_each(stage.sources, add);
    if (job.spec->render.colour.config) add(*job.spec->render.colour.config);
    return inputs;
}

Json versions_of(const Job& job) {
    Json versions = {{"cydonia", kVersion}, {"program", hex(job.program)}};
    for (const config::StageSpec& stage : job.spec->stages) {
        const Method method = method_of(stage.options);
        versions[std::string(method.name)] = method.version;
    }
    return versions;
}

constexpr Goal kStills[] = {Goal::kTerrain, Goal::kCheck, Goal::kEmit, Goal::kFrames};
constexpr Goal kSequences[] = {Goal::kSweep, Goal::kTurntable, Goal::kFilm};

// The finished steps of all goals that a request with these options can have.
std::vector<const Step*> finished_steps(Graph& graph, const Job& job) {
    std::vector<std::string> targets;
    const auto add = [&](Goal goal) {
        std::ranges::move(targets_of(goal, job), std::back_inserter(targets));
    };
    std::ranges::for_each(kStills, add);
    std::ranges::for_each(kSequences, add);
    std::vector<const Step*> finished;
    for (const Step* step : graph.closure(targets))
        if (graph.finished(step->id)) finished.push_back(step);
    return finished;
}

// Whether all targets of the goal are finished, apart from the report.
bool is_reached(Goal goal, Graph& graph, const Job& job) {
    std::vector<std::string> targets = targets_of(goal, job);
    std::erase(targets, kReportStep);
    return !targets.empty() && std::ranges::all_of(targets, [&](const std::string& id) {
        return graph.finished(id);
    });
}

// The last goal of the stills, whose targets include those of the goals before it, and
// all sequences.
std::vector<Goal> goals_of(Graph& graph, const Job& job) {
    std::vector<Goal> goals;
    for (const Goal goal : kStills)
        if (is_reached(goal, graph, job)) goals = {goal};
    for (const Goal goal : kSequences)
        if (is_reached(goal, graph, job)) goals.push_back(goal);
    return goals;
}

Json land_of(const Job& job) {
    const LandStore& land = job.land;
    return {{"samples", {land.width(), land.height()}},
            {"spacing", land.spacing()},
            {"extent", {land.spacing() * land.width(), land.spacing() * land.height()}},
            {"axes", {{"east", "x"}, {"north", "y"}, {"up", "z"}}},
            {"origin", "the south-western corner of the extent, at height 0"},
            {"rows", "from north to south"},
            {"unit", "metre"},
            {"drawn_factor", land.factor()}};
}

void add_outputs(Json& manifest, const Step& step, const StepRecord& record) {
    for (std::size_t i = 0; i < record.outputs.size(); ++i)
        manifest["outputs"].push_back({{"file", record.outputs[i]},
                                       {"step", step.id},
                                       {"bytes", record.sizes[i]},
                                       {"xxh3", hex(record.hashes[i])}});
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

Json manifest_of(Graph& graph, const Job& job) {
    Json manifest = {{"manifest", kManifestVersion},
                     {"title", job.spec->title},
                     {"scene", job.spec->name},
                     {"seed", job.spec->seed},
                     {"quality", name_of(job.request.quality)},
                     {"command", json_of(Command{goals_of(graph, job), job.request})},
                     {"versions", versions_of(job)},
                     {"inputs", inputs_of(job)},
                     {"options", options_of(*job.spec)},
                     {"land", land_of(job)},
                     {"figures", Json::object()},
                     {"outputs", Json::array()}};
    Json timings = {{"threads", job.request.threads}, {"seconds", Json::object()}};
    std::uint64_t peak = 0;
    for (const Step* step : finished_steps(graph, job)) {
        const StepRecord& record = *graph.finished(step->id);
        if (!record.result.empty()) manifest["figures"][step->id] = record.result;
        add_outputs(manifest, *step, record);
        timings["seconds"][step->id] = record.seconds;
        peak = std::max(peak, record.peak_memory);
    }
    timings["peak_memory"] = peak;
    manifest["timings"] = timings;
    return manifest;
}

}  // namespace cydonia
