#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/pipeline/memory.h"
#include "app/pipeline/steps.h"
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

// Figures of single features, such as "error of 'rim', m", are left to the manifest.
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

StepResult export_terrain(const Job& job) {
    const auto land = job.land.finished();
    const Terrain& terrain = *land;
    Metadata metadata = job.metadata();
    metadata["cydonia:spacing"] = fmt::format("{}", terrain.spacing);

    StepResult made{{"terrain.exr", "terrain.tif", "preview.png"}, measured(terrain)};
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
    return job.spec->stages[static_cast<std::size_t>(stage - 1)].options;
}

std::uint64_t stage_memory(const Job& job, int stage) {
    return memory::of_stage(options_of(job, stage), job.cells(),
                            static_cast<std::uint64_t>(thread_count()));
}

StepResult explain_stage(const Job& job, int stage) {
    make_folder(job.folder / "explain");
    StepResult made;
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
    if (made.outputs.empty())
        job.progress.note(stage_id(job, stage) + ": nothing to explain");
    return made;
}

StepResult make_stage(const Job& job, int stage, Ledger& ledger) {
    job.land.get(stage);
    // Explanations of an earlier land would mislead: they are removed.
    const std::string explanation = explain_id(job, stage);
    if (!job.request.explain && !ledger.outputs_of(explanation).empty())
        ledger.record(explanation, {});
    return {};
}

}  // namespace

std::string stage_id(const Job& job, int stage) {
    return fmt::format("{} {}", stage, method_of(options_of(job, stage)).name);
}

std::string explain_id(const Job& job, int stage) {
    return "explain " + stage_id(job, stage);
}

Step stage_step(const Job& job, int stage) {
    return {.id = stage_id(job, stage),
            .memory = stage_memory(job, stage),
            .key = [&job, stage] { return job.land.key(stage); },
            .run = [&job, stage](
                       Graph& graph) { return make_stage(job, stage, graph.ledger()); }};
}

Step explain_step(const Job& job, int stage) {
    return {.id = explain_id(job, stage),
            .memory = stage_memory(job, stage) + 16 * job.cells(),
            .key =
                [&job, stage] {
                    return KeyBuilder("explain")
                        .add(job.program)
                        .add(job.land.key(stage))
                        .key();
                },
            .run = [&job, stage](Graph&) { return explain_stage(job, stage); }};
}

Step export_step(const Job& job) {
    return {.id = kExportStep,
            .memory = memory::of_export(job.cells()),
            .key =
                [&job] {
                    return KeyBuilder("terrain")
                        .add(job.program)
                        .add(job.land.key())
                        .add(job.spec->name)
                        .key();
                },
            .run = [&job](Graph&) { return export_terrain(job); }};
}

}  // namespace cydonia
