#include <fmt/core.h>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "field/files.h"
#include "render/camera_view.h"
#include "render/cameras.h"
#include "render/pov/scene.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// The camera's own sun, else the scene's, else the one whose shadows show the first image
// (a stage may have chosen its azimuth), else late afternoon.
Sun chosen_sun(const render::CameraOptions& camera, const render::Options& options,
               const Terrain& terrain) {
    if (camera.sun) return *camera.sun;
    if (options.sun) return *options.sun;
    if (!terrain.shadows.empty()) return terrain.shadows.front().sun;
    return {radians(315.0), radians(35.0)};
}

// Names in the pov folder as outputs.
std::vector<std::string> in_pov(std::vector<std::string> names) {
    for (std::string& name : names) name.insert(0, "pov/");
    return names;
}

Made emit_assets(Job& job) {
    make_folder(job.folder / "pov");
    return {in_pov(render::write_pov_assets(job.folder / "pov", job.land.drawn(),
                                            job.spec.render, job.request.quality))};
}

Made emit_shot(Job& job, const render::CameraOptions& camera) {
    const Terrain& terrain = job.land.drawn();
    const render::Shot shot = shot_of(camera, job, terrain);
    return {
        in_pov(render::write_pov_scene(job.folder / "pov", shot, terrain)),
        {{"sun", json_of(shot.sun)}, {"size", {shot.camera.width, shot.camera.height}}}};
}

std::uint64_t emit_key(const Job& job, const std::string& what) {
    return hash_text(fmt::format("{:016x} {:016x} {} {} {}\n{}", job.land.key(),
                                 job.program, what, name_of(job.request.quality),
                                 job.spec.title, job.spec.render_text));
}

}  // namespace

render::Shot shot_of(const render::CameraOptions& camera, const Job& job,
                     const Terrain& terrain) {
    const Camera view =
        render::place(camera, terrain, job.request.quality, 0.0, job.spec.render.water);
    return {job.spec.title,
            camera.name,
            view,
            chosen_sun(camera, job.spec.render, terrain),
            job.spec.render,
            job.request.quality,
            render::around_of(terrain, job.spec.render),
            render::is_smooth(view, terrain)};
}

Step assets_step(Job& job) {
    return {kAssetsStep, Goal::kEmit, memory::of_emit(job.drawn_cells()),
            [&job] { return emit_key(job, "assets"); },
            [&job] { return emit_assets(job); }};
}

Step shot_step(Job& job, const render::CameraOptions& camera, const FrameOf& of) {
    std::string what = "shot " + camera.name;
    if (!of.camera.empty())
        what += fmt::format(" of {} {} {}", of.camera, camera.sun->azimuth,
                            camera.sun->elevation);
    return {shot_step_name(camera.name), Goal::kEmit, memory::of_emit(job.drawn_cells()),
            [&job, what] { return emit_key(job, what); },
            [&job, camera] { return emit_shot(job, camera); }};
}

std::string shot_step_name(const std::string& frame) { return "emit " + frame; }

}  // namespace cydonia
