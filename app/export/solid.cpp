// The land as a solid body, to be printed.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/export/export.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "field/files.h"

namespace cydonia {
namespace {

constexpr int kSolidSamples = 512;

struct SolidRequest {
    MeshFormat format;
    SolidOptions options;
};

std::string file_name(const Job& job, MeshFormat format) {
    return fmt::format("export/{}.{}", job.spec->name, name_of(format));
}

Json lamps_of(const Terrain& terrain, const SolidOptions& options) {
    Json lamps = Json::array();
    for (const ShadowImage& image : terrain.shadows) {
        lamps.push_back({{"image", image.name},
                         {"sun", json_of(image.sun)},
                         {"lamp", json_of(lamp_for(image.sun, options))}});
    }
    return lamps;
}

StepResult make_solid(const Job& job, const SolidRequest& asked) {
    const auto land = job.land.finished();
    const Terrain& terrain = *land;
    const Solid solid = solid_of(terrain, asked.options);
    const std::string file = file_name(job, asked.format);
    make_folder(job.folder / "export");
    write_text(job.folder / file, file_of(solid.mesh, asked.format));
    return with_sidecar(job, file,
                        {{"format", name_of(asked.format)},
                         {"unit", "millimetre"},
                         {"axes", axes("x", "y", "z")},
                         {"origin", "the south-western corner of the plate's underside"},
                         {"millimetres", {solid.size.x, solid.size.y, solid.size.z}},
                         {"base", asked.options.base},
                         {"scale_z", asked.options.scale_z},
                         {"millimetres_a_metre", solid.millimetres_a_metre},
                         {"lowest", *std::ranges::min_element(terrain.heights)},
                         {"samples", {solid.width, solid.height}},
                         {"triangles", solid.mesh.triangles.size()},
                         {"lamps", lamps_of(terrain, asked.options)}});
}

void say_its_size(const Json& result, const SolidRequest& asked, const Job& job) {
    const auto [east, north, high] =
        result.at("millimetres").get<std::array<double, 3>>();
    const auto [width, height] = result.at("samples").get<std::array<int, 2>>();
    const int longer = std::max(job.land.width(), job.land.height());
    job.progress.note(
        fmt::format("{}: {:.1f} x {:.1f} mm and {:.1f} mm high, {} mm of which is the "
                    "plate; scale 1:{:.0f}; {} triangles",
                    file_name(job, asked.format), east, north, high, asked.options.base,
                    1000.0 / result.at("millimetres_a_metre").get<double>(),
                    result.at("triangles").get<std::size_t>()));
    if (high - asked.options.base < 0.002 * asked.options.size)
        job.progress.warn("the land is nearly flat at this size; raise --scale-z");
    if (std::max(width, height) < longer) {
        job.progress.note(
            fmt::format("{} x {} samples were averaged to {} x {}; --samples, up to {}, "
                        "keeps more",
                        job.land.width(), job.land.height(), width, height,
                        std::min(longer, kMostSolidSamples)));
    }
}

// Metres. From here on a lamp's rays differ from the sun's by at most a degree; with
// more, the image falls apart (docs/sun-sweep.md).
double lamp_distance(const SolidOptions& options) {
    return options.size / 2.0 / std::tan(radians(1.0)) / 1000.0;
}

void say_its_lamps(const Json& result, const SolidOptions& options, Progress& progress) {
    for (const Json& lamp : result.at("lamps")) {
        const Sun sun = sun_of(lamp.at("lamp"));
        std::string as_in_scene;
        if (options.scale_z != 1.0)
            as_in_scene = fmt::format(" (the scene's sun: {:.1f})",
                                      degrees(sun_of(lamp.at("sun")).elevation));
        progress.note(fmt::format(
            "'{}' appears under a lamp at azimuth {:.1f} (clockwise from north), {:.1f} "
            "degrees above the plate{}, at least {:.1f} m away",
            lamp.at("image").get<std::string>(), degrees(sun.azimuth),
            degrees(sun.elevation), as_in_scene, lamp_distance(options)));
    }
}

}  // namespace

Step solid_step(const Job& job) {
    const ExportRequest& request = *job.request.export_as;
    SolidRequest asked{std::get<MeshFormat>(request.format), request.solid};
    asked.options.samples = samples_of(request, kSolidSamples, kMostSolidSamples);
    expect_in_range(asked.options);
    const auto key = [&job, options = asked.options] {
        return KeyBuilder("solid")
            .add(job.program)
            .add(job.land.key())
            .add(job.spec->name)
            .add(options.size)
            .add(options.base)
            .add(options.scale_z)
            .add(options.samples)
            .key();
    };
    return {.id = export_file_id(job),
            .memory = memory::of_solid(job.cells(), asked.options.samples),
            .key = key,
            .run = [&job, asked](Graph&) { return make_solid(job, asked); },
            .gate =
                [&job, asked](const Json& result) {
                    say_its_size(result, asked, job);
                    say_its_lamps(result, asked.options, job.progress);
                }};
}

}  // namespace cydonia
