#include "app/pipeline/job.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "render/cameras/cameras.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

fs::path folder_for(const Request& request, const std::string& scene) {
    return request.output.empty() ? fs::path("out") / scene : request.output;
}

}  // namespace

Job::Job(const Request& asked, Progress& sink)
    : request(asked),
      scene_file(open_source(asked.scene)),
      scene(config::Scene::load(asked.scene, asked.overrides)),
      spec(std::make_shared<const config::SceneSpec>(at(0.0))),
      folder(folder_for(asked, spec->name)),
      land(land_of(spec, sink)),
      progress(sink),
      program(open_source("/proc/self/exe").hash) {}

std::uint64_t Job::cells() const {
    return static_cast<std::uint64_t>(land.width()) *
           static_cast<std::uint64_t>(land.height());
}

std::uint64_t Job::drawn_cells() const {
    const auto factor = static_cast<std::uint64_t>(land.factor());
    return factor * factor * cells();
}

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

LandStore Job::land_of(std::shared_ptr<const config::SceneSpec> then,
                       Progress& sink) const {
    // A preview by Embree draws the land as a draft does.
    const auto quality = request.preview ? render::Quality::kDraft : request.quality;
    return {std::move(then), quality, folder / ".cache", sink};
}

config::SceneSpec Job::at(double frame) const {
    config::SceneSpec then = scene.at(frame);
    for (render::CameraOptions& camera : then.render.cameras) resize(camera);
    return then;
}

std::vector<render::CameraOptions> Job::cameras() const {
    std::vector<render::CameraOptions> all = spec->render.cameras;
    if (all.empty()) {
        all = render::default_cameras();
        for (render::CameraOptions& camera : all) resize(camera);
    }
    if (request.first_camera_only) all.resize(1);
    return all;
}

Metadata Job::metadata() const {
    return {{"cydonia:scene", spec->name},
            {"cydonia:seed", fmt::format("{}", spec->seed)},
            {"cydonia:version", kVersion}};
}

std::uint64_t pixels_of(const render::CameraOptions& camera) {
    return static_cast<std::uint64_t>(camera.size[0]) *
           static_cast<std::uint64_t>(camera.size[1]);
}

std::uint64_t most_pixels(const Job& job) {
    std::uint64_t most = 0;
    for (const render::CameraOptions& camera : job.cameras())
        most = std::max(most, pixels_of(camera));
    return most;
}

}  // namespace cydonia
