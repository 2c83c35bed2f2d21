#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "app/threads.h"
#include "field/dem.h"
#include "field/files.h"
#include "render/preview.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

Field<std::uint16_t> mask_levels(const Field<float>& mask) {
    Field<std::uint16_t> levels(mask.width(), mask.height());
    std::ranges::transform(mask, levels.begin(), [](float value) {
        return static_cast<std::uint16_t>(
            std::lround(std::clamp(value, 0.0f, 1.0f) * 65535.0f));
    });
    return levels;
}

Json measured(const Terrain& terrain) {
    const auto [low, high] = std::ranges::minmax_element(terrain.heights);
    return {{"samples", {terrain.heights.width(), terrain.heights.height()}},
            {"spacing", terrain.spacing},
            {"extent", {terrain.width(), terrain.depth()}},
            {"lowest", *low},
            {"highest", *high}};
}

Made export_terrain(Job& job) {
    const Terrain& terrain = job.land.finished();
    Metadata metadata = job.metadata();
    metadata["cydonia:spacing"] = fmt::format("{}", terrain.spacing);

    Made made{{"terrain.exr", "terrain.tif", "preview.png"}, measured(terrain)};
    write_exr(job.folder / "terrain.exr", terrain.heights, "Y", metadata);
    write_geotiff(job.folder / "terrain.tif", terrain);
    write_png(job.folder / "preview.png",
              render::hillshade(terrain.heights, terrain.spacing));
    if (!terrain.masks.empty()) make_folder(job.folder / "masks");
    for (const auto& [name, mask] : terrain.masks) {
        made.outputs.push_back(fmt::format("masks/{}.png", name));
        write_png(job.folder / made.outputs.back(), mask_levels(mask));
    }
    return made;
}

}  // namespace

std::vector<Step> stage_steps(Job& job) {
    const auto threads = static_cast<std::uint64_t>(thread_count());
    std::vector<Step> steps;
    for (int stage = 1; stage <= job.land.stages(); ++stage) {
        const StageOptions& options =
            job.spec.stages[static_cast<std::size_t>(stage - 1)].options;
        steps.push_back({fmt::format("{} {}", stage, method_of(options).name),
                         Goal::kTerrain, memory::of_stage(options, job.cells(), threads),
                         [&job, stage] { return job.land.key(stage); },
                         [&job, stage] {
                             job.land.after(stage);
                             return Made{};
                         }});
    }
    return steps;
}

Step export_step(Job& job) {
    return {"terrain", Goal::kTerrain, memory::of_export(job.cells()),
            [&job] {
                return hash_text(fmt::format("{:016x} {:016x} {}", job.land.key(),
                                             job.program, job.spec.name));
            },
            [&job] { return export_terrain(job); }};
}

}  // namespace cydonia
