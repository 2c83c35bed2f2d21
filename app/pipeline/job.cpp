#include "app/pipeline/job.h"

#include <fmt/core.h>

#include <cmath>

#include "app/export/export.h"
#include "app/pipeline/report_step.h"
#include "app/pipeline/tiles.h"
#include "app/sequence/steps.h"
#include "render/cameras/cameras.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

fs::path folder_for(const Request& request, const std::string& scene) {
    return request.output.empty() ? fs::path("out") / scene : request.output;
}

// A look makes frames only; the page shows what was made of the land before, too.
std::vector<Step> with_what_else_there_is(Job& job, std::vector<Step> steps) {
    steps.push_back(export_step(job));
    steps.push_back(check_step(job));
    for (const render::CameraOptions& camera : job.cameras())
        for (Step& step : frame_steps(job, camera)) steps.push_back(std::move(step));
    return steps;
}

}  // namespace

Job::Job(const Request& asked, Progress& sink)
    : request(asked),
      scene_file(open_source(asked.scene)),
      scene(config::Scene::load(asked.scene, asked.overrides)),
      spec(at(0.0)),
      folder(folder_for(asked, spec.name)),
      land(land_of(spec, sink)),
      ledger(folder),
      progress(sink),
      program(open_source("/proc/self/exe").hash) {}

fs::path output_of(const Request& request) {
    if (!request.output.empty()) return request.output;
    return folder_for(request,
                      config::Scene::load(request.scene, request.overrides).at(0.0).name);
}

void Job::resize(render::CameraOptions& camera) const {
    if (!request.size) return;
    const double thirds = 1.0 + static_cast<int>(request.quality);
    for (std::size_t i = 0; i < 2; ++i)
        camera.size[i] = static_cast<int>(std::lround((*request.size)[i] * 3.0 / thirds));
}

Land Job::land_of(const config::SceneSpec& then, Progress& sink) const {
    // A look in a second is at no finer land than a draft.
    return {then, request.preview ? render::Quality::kDraft : request.quality,
            folder / ".cache", sink};
}

config::SceneSpec Job::at(double frame) const {
    config::SceneSpec then = scene.at(frame);
    for (render::CameraOptions& camera : then.render.cameras) resize(camera);
    return then;
}

std::vector<render::CameraOptions> Job::cameras() const {
    std::vector<render::CameraOptions> all = spec.render.cameras;
    if (all.empty()) {
        all = render::default_cameras();
        for (render::CameraOptions& camera : all) resize(camera);
    }
    if (request.first_camera_only) all.resize(1);
    return all;
}

Metadata Job::metadata() const {
    return {{"cydonia:scene", spec.name},
            {"cydonia:seed", fmt::format("{}", spec.seed)},
            {"cydonia:version", kVersion}};
}

std::vector<Step> steps_of(Job& job) {
    if (job.spec.terrain.tiles > 0) return {tiles_step(job)};
    std::vector<Step> steps = stage_steps(job);
    if (job.request.preview) {
        for (Step& step : preview_steps(job)) steps.push_back(std::move(step));
        for (Step& step : sequence_steps(job)) steps.push_back(std::move(step));
        steps.push_back(report_step(job, with_what_else_there_is(job, steps)));
        return steps;
    }
    steps.push_back(export_step(job));
    if (job.request.export_as) steps.push_back(export_file_step(job));
    steps.push_back(check_step(job));
    steps.push_back(assets_step(job));
    for (const render::CameraOptions& camera : job.cameras()) {
        steps.push_back(shot_step(job, camera));
    }
    for (const render::CameraOptions& camera : job.cameras()) {
        for (Step& step : frame_steps(job, camera)) steps.push_back(std::move(step));
        if (job.spec.render.passes) steps.push_back(passes_step(job, camera));
    }
    for (Step& step : sequence_steps(job)) steps.push_back(std::move(step));
    steps.push_back(report_step(job, steps));
    return steps;
}

}  // namespace cydonia
