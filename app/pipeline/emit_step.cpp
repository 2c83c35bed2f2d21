#include <fmt/core.h>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "field/files.h"
#include "render/cameras/cameras.h"
#include "render/cameras/view.h"
#include "render/pov/scene.h"
#include "render/scene/files.h"

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
    const Terrain& land = job.land.drawn();
    const Heights16 heights = quantised(land.heights);
    return {
        in_pov(render::write_pov_assets(
            job.folder / "pov", land,
            render::land_maps(land, job.spec.render.ground, job.request.quality))),
        {{"heights.png",
          {{"samples", {land.heights.width(), land.heights.height()}},
           {"metres", {{"offset", heights.base}, {"scale", heights.range / 65535.0}}}}}}};
}

std::uint64_t emit_key(const Job& job, const config::SceneSpec& scene,
                       const std::string& what) {
    return hash_text(fmt::format("{:016x} {:016x} {} {} {}\n{}", job.land.key(),
                                 job.program, what, name_of(job.request.quality),
                                 scene.title, scene.render_text));
}

}  // namespace

render::Shot shot_of(const render::CameraOptions& camera, const Job& job,
                     const config::SceneSpec& scene, const Terrain& terrain) {
    const Camera view =
        render::place(camera, terrain, job.request.quality, scene.render.water);
    return {scene.title,
            camera.name,
            view,
            chosen_sun(camera, scene.render, terrain),
            scene.render,
            job.request.quality,
            render::around_of(terrain, scene.render),
            render::is_smooth(view, terrain)};
}

const config::SceneSpec& scene_of(const Job& job, const FrameOf& of) {
    return of.scene ? *of.scene : job.spec;
}

std::shared_ptr<const Site> site_of(Job& job, const FrameOf& of) {
    return of.site ? of.site()
                   : std::make_shared<const Site>(job.land.drawn(), job.folder / "pov");
}

std::string text_of(const render::CameraOptions& camera, const FrameOf& of) {
    std::string text = fmt::format("{} of {}", camera.name, of.camera);
    for (const render::CameraOptions& picture : pictures_of(camera, of)) {
        text += fmt::format(" {}x{} {} {}", picture.size[0], picture.size[1],
                            picture.frame, picture.turn);
        if (picture.sun)
            text += fmt::format(" {} {}", picture.sun->azimuth, picture.sun->elevation);
    }
    return text;
}

std::vector<render::CameraOptions> pictures_of(const render::CameraOptions& camera,
                                               const FrameOf& of) {
    if (of.moments.empty()) return {camera};
    std::vector<render::CameraOptions> pictures = of.moments;
    for (std::size_t i = 0; i < pictures.size(); ++i)
        pictures[i].name = render::moment_name(camera.name, static_cast<int>(i) + 1);
    return pictures;
}

Step assets_step(Job& job) {
    return {kAssetsStep, Goal::kAssets, memory::of_emit(job.drawn_cells()),
            [&job] { return emit_key(job, job.spec, "assets"); },
            [&job] { return emit_assets(job); }};
}

Made write_pictures(const Job& job, const Site& site, const render::CameraOptions& camera,
                    const FrameOf& of) {
    Made made;
    for (const render::CameraOptions& picture : pictures_of(camera, of)) {
        const render::Shot shot = shot_of(picture, job, scene_of(job, of), site.terrain);
        for (std::string& name : render::write_pov_scene(site.pov, shot, site.terrain))
            made.outputs.push_back(std::move(name));
        made.result = {{"sun", json_of(shot.sun)},
                       {"size", {shot.camera.width, shot.camera.height}}};
    }
    return made;
}

Step shot_step(Job& job, const render::CameraOptions& camera, const FrameOf& of) {
    return {shot_step_name(camera.name), Goal::kEmit, memory::of_emit(job.drawn_cells()),
            [&job, camera, of] {
                return emit_key(job, scene_of(job, of), "shot " + text_of(camera, of));
            },
            [&job, camera, of] {
                Made made = write_pictures(job, *site_of(job, of), camera, of);
                made.outputs = in_pov(std::move(made.outputs));
                return made;
            }};
}

std::string shot_step_name(const std::string& frame) { return "emit " + frame; }

}  // namespace cydonia
