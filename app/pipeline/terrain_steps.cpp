#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "app/threads.h"
#include "field/dem.h"
#include "field/file_names.h"
#include "field/files.h"
#include "render/maps/hillshade.h"

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

std::map<std::string, Field<float>> masks_of(const Terrain& terrain) {
    auto masks = terrain.masks;
    if (terrain.water.empty()) return masks;
    Field<float>& wet = masks["water"] = water_depths(terrain);
    for (float& depth : wet) depth = depth > 0.0f ? 1.0f : 0.0f;
    return masks;
}

Json measured(const Terrain& terrain) {
    const auto [low, high] = std::ranges::minmax_element(terrain.heights);
    return {{"samples", {terrain.heights.width(), terrain.heights.height()}},
            {"spacing", terrain.spacing},
            {"extent", {terrain.width(), terrain.depth()}},
            {"lowest", *low},
            {"highest", *high},
            {"figures", terrain.figures}};
}

// Not those of one among many ("error of 'rim', m"): the manifest has all.
void say_figures(const Terrain& terrain, Progress& progress) {
    std::size_t left = 0;
    for (const auto& [name, value] : terrain.figures) {
        if (name.find(" of '") != name.npos)
            ++left;
        else
            progress.note(fmt::format("{}: {:.4g}", name, value));
    }
    if (left > 0) progress.note(fmt::format("and {} more in manifest.json", left));
}

Made export_terrain(Job& job) {
    const Terrain& terrain = job.land.finished();
    Metadata metadata = job.metadata();
    metadata["cydonia:spacing"] = fmt::format("{}", terrain.spacing);

    Made made{{"terrain.exr", "terrain.tif", "preview.png"}, measured(terrain)};
    write_exr(job.folder / "terrain.exr", terrain.heights, "Y", metadata);
    write_geotiff(job.folder / "terrain.tif", terrain);
    write_png(job.folder / "preview.png", render::hillshade(terrain));
    const auto masks = masks_of(terrain);
    if (!masks.empty() || !terrain.pictures.empty()) make_folder(job.folder / "masks");
    std::vector<std::string> names;
    for (const auto& [name, mask] : masks) names.push_back(name);
    for (const auto& [name, picture] : terrain.pictures) names.push_back(name);
    names = file_names_of(names);
    auto file = names.begin();
    for (const auto& [name, mask] : masks) {
        made.outputs.push_back(fmt::format("masks/{}.png", *file++));
        write_png(job.folder / made.outputs.back(), mask_levels(mask));
    }
    for (const auto& [name, picture] : terrain.pictures) {
        made.outputs.push_back(fmt::format("masks/{}.png", *file++));
        write_png(job.folder / made.outputs.back(), picture);
    }
    say_figures(terrain, job.progress);
    return made;
}

const StageOptions& options_of(const Job& job, int stage) {
    return job.spec.stages[static_cast<std::size_t>(stage - 1)].options;
}

std::string stage_name(const Job& job, int stage) {
    return fmt::format("{} {}", stage, method_of(options_of(job, stage)).name);
}

std::uint64_t stage_memory(const Job& job, int stage) {
    return memory::of_stage(options_of(job, stage), job.cells(),
                            static_cast<std::uint64_t>(thread_count()));
}

Made explain_stage(Job& job, int stage) {
    make_folder(job.folder / "explain");
    Made made;
    const auto place = [&](const std::string& name, const char* extension) {
        made.outputs.push_back(fmt::format("explain/{}-{}.{}", stage, name, extension));
        return job.folder / made.outputs.back();
    };
    const Explain sinks{[&](const std::string& name, const Field<Rgb8>& picture) {
                            write_png(place(name, "png"), picture);
                        },
                        [&](const std::string& name, const std::string& csv) {
                            write_text(place(name, "csv"), csv);
                        }};
    job.land.explained(stage, sinks);
    if (made.outputs.empty()) {
        job.progress.note(stage_name(job, stage) + ": nothing to explain");
    }
    return made;
}

std::string explain_name(const Job& job, int stage) {
    return "explain " + stage_name(job, stage);
}

Step explain_step(Job& job, int stage) {
    return {explain_name(job, stage), Goal::kTerrain,
            stage_memory(job, stage) + 16 * job.cells(),
            [&job, stage] {
                return hash_text(fmt::format("explain {:016x} {:016x}",
                                             job.land.key(stage), job.program));
            },
            [&job, stage] { return explain_stage(job, stage); }};
}

Made make_stage(Job& job, int stage) {
    job.land.after(stage);
    // Pictures of the land as it was are worse than none.
    const std::string explanation = explain_name(job, stage);
    if (!job.request.explain && !job.ledger.outputs_of(explanation).empty()) {
        job.ledger.record(explanation, {});
    }
    return {};
}

}  // namespace

std::vector<Step> stage_steps(Job& job) {
    std::vector<Step> steps;
    for (int stage = 1; stage <= job.land.stages(); ++stage) {
        if (job.request.explain) steps.push_back(explain_step(job, stage));
        steps.push_back({stage_name(job, stage), Goal::kTerrain, stage_memory(job, stage),
                         [&job, stage] { return job.land.key(stage); },
                         [&job, stage] { return make_stage(job, stage); }});
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
