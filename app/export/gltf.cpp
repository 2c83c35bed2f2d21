// glTF: the scene for other 3D programs.
#include <fmt/core.h>

#include "app/export/export.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "field/files.h"
#include "render/gltf/scene.h"

namespace cydonia {
namespace {

constexpr int kGltfSamples = 512;

std::string file_name(const Job& job) {
    return fmt::format("export/{}.glb", job.spec->name);
}

StepResult make_gltf(const Job& job, int samples) {
    const auto land = job.land.drawn();
    const Terrain& terrain = *land;
    std::vector<render::Shot> shots;
    for (const render::CameraOptions& camera : job.cameras())
        shots.push_back(shot_of(camera, *job.spec, job.request.quality, terrain));
    const render::GltfScene made = render::gltf_scene(terrain, shots, samples);
    make_folder(job.folder / "export");
    write_text(job.folder / file_name(job), made.file);

    Json cameras = Json::array();
    for (const render::Shot& shot : shots) cameras.push_back(shot.name);
    return with_sidecar(
        job, file_name(job),
        {{"format", "glb"},
         {"unit", "metre"},
         {"axes", axes("x", "-z", "y")},
         {"origin", "the south-western corner of the extent, at height 0"},
         {"extent", {terrain.width(), terrain.depth()}},
         {"samples", made.samples},
         {"triangles", made.triangles},
         {"colour_pixels", made.colour},
         {"normal_pixels", made.normals},
         {"sun", json_of(shots.front().sun)},
         {"lux", made.lux},
         {"cameras", cameras}});
}

void say_what_it_is(const Json& result, const Job& job) {
    job.progress.note(fmt::format(
        "{}: {:g} x {:g} m, y up, north at -z; {} triangles, {} cameras, the sun at "
        "{:.0f} lux",
        file_name(job), result.at("extent")[0].get<double>(),
        result.at("extent")[1].get<double>(), result.at("triangles").get<std::size_t>(),
        result.at("cameras").size(), result.at("lux").get<double>()));
}

}  // namespace

Step gltf_step(const Job& job) {
    const int samples =
        samples_of(*job.request.export_as, kGltfSamples, render::kMostGltfSamples);
    const auto key = [&job, samples] {
        return KeyBuilder("glb")
            .add(job.program)
            .add(job.land.drawn_key())
            .add(samples)
            .add(job.request.quality)
            .add(job.spec->name)
            .add(job.spec->title)
            .add(job.spec->render_text)
            .key();
    };
    return {.id = export_file_id(job),
            .memory = memory::of_gltf(job.drawn_cells(), samples),
            .key = key,
            .run = [&job, samples](Graph&) { return make_gltf(job, samples); },
            .gate = [&job](const Json& result) { say_what_it_is(result, job); }};
}

}  // namespace cydonia
