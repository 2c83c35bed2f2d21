#include "app/pipeline/manifest.h"

#include <algorithm>

namespace cydonia {
namespace {

Json json_of(const Source& source) {
    return {{"file", source.name()}, {"bytes", source.size}, {"xxh3", hex(source.hash)}};
}

Json inputs_of(const Job& job) {
    Json inputs = {{"scene", json_of(job.scene_file)},
                   {"set", job.request.overrides},
                   {"files", Json::array()}};
    for (const config::StageSpec& stage : job.spec.stages) {
        for (const Source& source : stage.sources) {
            inputs["files"].push_back(json_of(source));
        }
    }
    if (job.spec.render.colour.config) {
        inputs["files"].push_back(json_of(*job.spec.render.colour.config));
    }
    return inputs;
}

Json versions_of(const Job& job) {
    Json versions = {{"cydonia", kVersion}};
    for (const config::StageSpec& stage : job.spec.stages) {
        const Method method = method_of(stage.options);
        versions[std::string(method.name)] = method.version;
    }
    return versions;
}

}  // namespace

Json manifest_of(const std::vector<Step>& steps, const Job& job) {
    Json manifest = {
        {"title", job.spec.title},      {"scene", job.spec.name},
        {"seed", job.spec.seed},        {"quality", name_of(job.request.quality)},
        {"versions", versions_of(job)}, {"inputs", inputs_of(job)},
        {"figures", Json::object()},    {"outputs", Json::array()}};
    Json timings = Json::object();
    std::uint64_t peak = 0;
    for (const Step& step : steps) {
        const Entry* entry = job.ledger.finished(step.name, step.key());
        if (!entry) continue;
        if (!entry->result.empty()) manifest["figures"][step.name] = entry->result;
        for (const std::string& file : entry->outputs)
            manifest["outputs"].push_back(file);
        timings["seconds"][step.name] = entry->seconds;
        peak = std::max(peak, entry->peak_memory);
    }
    timings["peak_memory"] = peak;
    manifest["timings"] = timings;
    return manifest;
}

}  // namespace cydonia
