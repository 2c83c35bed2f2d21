#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "field/files.h"
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

render::Shot shot_of(const render::CameraOptions& camera, const Job& job,
                     const Terrain& terrain) {
    return {job.spec.title,
            camera.name,
            render::place(camera, terrain, job.request.quality),
            chosen_sun(camera, job.spec.render, terrain),
            job.spec.render,
            job.request.quality};
}

Made emit(Job& job) {
    const fs::path folder = job.folder / "pov";
    const Terrain& terrain = job.land.finished();
    make_folder(folder);
    render::write_pov_assets(folder, terrain, job.spec.render);
    Made made{pov_assets(), {{"frames", Json::array()}}};
    for (const render::CameraOptions& camera : job.cameras()) {
        const render::Shot shot = shot_of(camera, job, terrain);
        render::write_pov_scene(folder, shot, terrain);
        std::ranges::copy(pov_files(shot.name), std::back_inserter(made.outputs));
        made.result["frames"].push_back({{"name", shot.name},
                                         {"sun", json_of(shot.sun)},
                                         {"width", shot.camera.width},
                                         {"height", shot.camera.height}});
    }
    return made;
}

}  // namespace

std::vector<std::string> pov_assets() { return {"pov/heights.png", "pov/ground.png"}; }

std::vector<std::string> pov_files(const std::string& frame) {
    return {"pov/sky_" + frame + ".exr", "pov/" + frame + ".pov",
            "pov/" + frame + ".ini"};
}

Step emit_step(Job& job) {
    return {"emit", Goal::kEmit, memory::of_emit(job.cells()),
            [&job] {
                return hash_text(fmt::format("{:016x} {:016x} {} {}\n{}", job.land.key(),
                                             job.program, name_of(job.request.quality),
                                             job.spec.title, job.spec.render_text));
            },
            [&job] { return emit(job); }};
}

}  // namespace cydonia
