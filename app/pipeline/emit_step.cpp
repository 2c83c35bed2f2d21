#include "app/pipeline/memory.h"
#include "app/pipeline/pictures.h"
#include "app/pipeline/shadow_report.h"
#include "app/pipeline/steps.h"
#include "field/files.h"
#include "render/pov/scene.h"
#include "render/scene/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// Files of the folder pov/ as outputs, which are relative to the output folder.
std::vector<std::string> in_pov(std::vector<std::string> names) {
    for (std::string& name : names) name.insert(0, "pov/");
    return names;
}

StepResult emit_assets(const Job& job) {
    make_folder(job.folder / "pov");
    const auto land = job.land.drawn();
    const Heights16 heights = quantised(land->heights);
    return {
        in_pov(render::write_pov_assets(
            job.folder / "pov", *land,
            render::land_maps(*land, job.spec->render.ground, job.request.quality))),
        {{"heights.png",
          {{"samples", {land->heights.width(), land->heights.height()}},
           {"metres", {{"offset", heights.base}, {"scale", heights.range / 65535.0}}}}}}};
}

}  // namespace

StepResult write_pictures(const Job& job, const Site& site, const Frame& frame) {
    StepResult made;
    for (const render::CameraOptions& picture : pictures_of(frame)) {
        const render::Shot shot =
            shot_of(picture, *frame.scene, job.request.quality, *site.terrain);
        for (std::string& name : render::write_pov_scene(site.pov, shot, *site.terrain))
            made.outputs.push_back(std::move(name));
        made.result = {{"sun", json_of(shot.sun)},
                       {"size", {shot.camera.width, shot.camera.height}}};
    }
    return made;
}

std::vector<std::string> files_of_pictures(const Frame& frame) {
    using enum render::ShotFile;
    std::vector<std::string> names;
    for (const render::CameraOptions& picture : pictures_of(frame))
        for (const render::ShotFile file : {kScene, kSettings, kSky})
            names.push_back(render::file_of(picture.name, file));
    return in_pov(std::move(names));
}

std::string emit_id(const std::string& frame) { return "emit " + frame; }

Step assets_step(const Job& job) {
    const auto key = [&job] {
        return KeyBuilder("assets")
            .add(job.program)
            .add(job.land.key())
            .add(job.request.quality)
            .add(job.spec->title)
            .add(job.spec->render_text)
            .key();
    };
    return {.id = kAssetsStep,
            .memory = memory::of_emit(job.drawn_cells()),
            .key = key,
            .run = [&job](Graph&) { return emit_assets(job); }};
}

Step emit_step(const Job& job, const Frame& frame) {
    const auto key = [frame] {
        KeyBuilder builder("emit");
        builder.add(frame.scene->title).add(frame.scene->render_text);
        add_to(builder, frame);
        return builder.key();
    };
    const auto run = [&job, frame](Graph&) {
        StepResult made = write_pictures(job, *frame.land.site(), frame);
        made.outputs = in_pov(std::move(made.outputs));
        return made;
    };
    return {.id = emit_id(frame.camera.name),
            .memory = memory::of_emit(job.drawn_cells()),
            .key = key,
            .run = run,
            .writes = [frame] { return files_of_pictures(frame); }};
}

}  // namespace cydonia
