// Passes for compositing (render/passes), from the frame's camera over the frame's land:
// all in frames/<camera>.passes.exr, or each in a file of its own.
#include <algorithm>

#include "app/pipeline/memory.h"
#include "app/pipeline/steps.h"
#include "field/image.h"
#include "render/passes/passes.h"

namespace cydonia {
namespace {

Key passes_key(const Job& job, const Frame& frame) {
    KeyBuilder key("passes");
    key.add(job.program).add(job.request.quality).add(frame.land.key);
    key.add(frame.scene->render_text);
    add_to(key, frame);
    if (!frame.next) return key.add("still").key();
    Frame next = frame;
    next.camera = *frame.next;
    add_to(key, next);
    return key.key();
}

// 1 where the first mask called "type-..." is the largest, 2 where the second is, and so
// on.
Field<std::uint8_t> types_of(const Terrain& terrain) {
    Field<std::uint8_t> types;
    Field<float> most;  // smaller shares do not count
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

render::PassMaps maps_of(const Site& site) {
    const auto maps = site.maps();
    return {maps->ground.materials, types_of(*site.terrain), maps->sky_visibility};
}

StepResult make_passes(const Job& job, const Frame& frame) {
    const render::PassOptions& options = *job.spec->render.passes;
    const auto site = frame.land.site();
    const Terrain& terrain = *site->terrain;
    const render::PassMaps maps = maps_of(*site);
    const auto shot_from = [&](const render::CameraOptions& camera) {
        return shot_of(camera, *frame.scene, job.request.quality, terrain);
    };
    const render::Shot shot = shot_from(frame.camera);
    const render::View view(terrain, render::scenery_of(shot, terrain));
    frame.progress->report(0.1);
    const render::CameraRays rays(shot.camera);
    const auto points = view.seen(rays, shot.smooth);
    frame.progress->report(0.4);
    auto layers = render::passes(view, points, shot.sun, maps, options.which);
    if (frame.next && std::ranges::count(options.which, render::Pass::kMotion))
        layers.push_back(render::motion_pass(
            points, rays, render::CameraRays(shot_from(*frame.next).camera)));
    frame.progress->report(0.7);

    const std::string& name = frame.camera.name;
    Metadata metadata = job.metadata();
    metadata["cydonia:camera"] = name;
    metadata["cydonia:space"] = "metres; x east, y north, z up; Z along the view's axis";
    const int width = points.width(), height = points.height();
    StepResult made;
    const auto write = [&](const std::string& pass, const Field<Rgb>& beauty,
                           const std::vector<render::PassLayer>& parts) {
        made.outputs.push_back("frames/" + name + "." + pass + ".exr");
        render::write_passes(job.folder / made.outputs.back(), beauty, parts, width,
                             height, metadata);
    };
    if (options.separate)
        for (const render::PassLayer& layer : layers) write(layer.name, {}, {layer});
    else
        write("passes", read_exr_rgb(job.folder / "frames" / (name + ".exr")), layers);
    return made;
}

}  // namespace

std::string passes_id(const std::string& frame) { return "passes " + frame; }

Step passes_step(const Job& job, const Frame& frame) {
    return {
        .id = passes_id(frame.camera.name),
        .memory = std::max(memory::of_emit(job.drawn_cells()),  // for the maps
                           memory::of_passes(job.drawn_cells(), pixels_of(frame.camera))),
        .key = [&job, frame] { return passes_key(job, frame); },
        .run = [&job, frame](Graph&) { return make_passes(job, frame); }};
}

}  // namespace cydonia
