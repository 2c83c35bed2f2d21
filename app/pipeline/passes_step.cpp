// What compositors want besides the frame: render/passes, from the same camera over the
// same land, in frames/<camera>.passes.exr or a file each.
#include <fmt/core.h>

#include <algorithm>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "field/image.h"
#include "render/passes/passes.h"

namespace cydonia {
namespace {

std::uint64_t passes_key(const Job& job, const render::CameraOptions& camera,
                         const FrameOf& of,
                         const std::optional<render::CameraOptions>& next) {
    return hash_text(fmt::format(
        "passes {:016x} {:016x} {:016x} {} {} {}\n{}", of.site ? of.land : job.land.key(),
        job.program, hash_of_file(job.folder / "frames" / (camera.name + ".exr")),
        text_of(camera, of), next ? text_of(*next, of) : "still",
        name_of(job.request.quality), scene_of(job, of).render_text));
}

// 1 where the first mask called "type-..." is most, 2 where the second is, ...
Field<std::uint8_t> types_of(const Terrain& terrain) {
    Field<std::uint8_t> types;
    Field<float> most;  // between samples several types have a share
    std::uint8_t number = 0;
    for (const auto& [name, mask] : terrain.masks) {
        if (!name.starts_with("type-")) continue;
        if (types.empty()) {
            types = Field<std::uint8_t>(mask.width(), mask.height());
            most = Field<float>(mask.width(), mask.height(), 0.01f);
        }
        ++number;
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (mask[i] > most[i]) types[i] = number, most[i] = mask[i];
    }
    return types;
}

// As POV-Ray had them.
render::PassMaps maps_of(const Site& site) {
    render::PassMaps maps;
    maps.types = types_of(site.terrain);
    const Field<Rgba8> materials = read_rgba(open_source(site.pov / "materials.png"));
    maps.materials = Field<std::uint8_t>(materials.width(), materials.height());
    for (std::size_t i = 0; i < materials.size(); ++i)
        maps.materials[i] = materials[i][0];
    maps.sky_visibility = read_grey(open_source(site.pov / "sky_visibility.png"));
    return maps;
}

Made make_passes(Job& job, const render::CameraOptions& camera, const FrameOf& of,
                 const std::optional<render::CameraOptions>& next) {
    Progress& progress = of.progress ? *of.progress : job.progress;
    const render::PassOptions& options = *job.spec.render.passes;
    const config::SceneSpec& scene = scene_of(job, of);
    const auto site = site_of(job, of);
    const Terrain& terrain = site->terrain;
    const render::Shot shot = shot_of(camera, job, scene, terrain);
    const render::View view(terrain, render::scenery_of(shot, terrain));
    progress.report(0.1);
    const render::CameraRays rays(shot.camera);
    const auto points = view.seen(rays, shot.smooth);
    progress.report(0.4);
    auto layers = render::passes(view, points, shot.sun, maps_of(*site), options.which);
    if (next && std::ranges::count(options.which, render::Pass::kMotion))
        layers.push_back(render::motion_pass(
            points, rays,
            render::CameraRays(shot_of(*next, job, scene, terrain).camera)));
    progress.report(0.7);

    Metadata metadata = job.metadata();
    metadata["cydonia:camera"] = camera.name;
    metadata["cydonia:space"] = "metres; x east, y north, z up; Z along the view's axis";
    const int width = points.width(), height = points.height();
    Made made;
    const auto write = [&](const std::string& pass, const Field<Rgb>& beauty,
                           const std::vector<render::PassLayer>& parts) {
        made.outputs.push_back("frames/" + camera.name + "." + pass + ".exr");
        render::write_passes(job.folder / made.outputs.back(), beauty, parts, width,
                             height, metadata);
    };
    if (options.separate)
        for (const render::PassLayer& layer : layers) write(layer.name, {}, {layer});
    else
        write("passes", read_exr_rgb(job.folder / "frames" / (camera.name + ".exr")),
              layers);
    return made;
}

}  // namespace

Step passes_step(Job& job, const render::CameraOptions& camera, const FrameOf& of,
                 const std::optional<render::CameraOptions>& next) {
    const auto pixels = static_cast<std::uint64_t>(camera.size[0]) *
                        static_cast<std::uint64_t>(camera.size[1]);
    return {
        .name = "passes " + camera.name,
        .goal = Goal::kFrames,
        .memory = memory::of_passes(job.drawn_cells(), pixels),
        .key = [&job, camera, of, next] { return passes_key(job, camera, of, next); },
        .run = [&job, camera, of, next] { return make_passes(job, camera, of, next); }};
}

}  // namespace cydonia
