// Previews: frames by Embree (render/embree) in about a second, without POV-Ray.
#include <fmt/core.h>

#include <memory>
#include <optional>

#include "app/pipeline/memory.h"
#include "app/pipeline/steps.h"
#include "field/files.h"
#include "render/embree/diagram.h"
#include "render/embree/preview_frame.h"
#include "render/frames/frame.h"

namespace cydonia {
namespace {

// What all cameras of a scene share; the first to be drawn makes it.
using SharedLand = std::shared_ptr<std::optional<render::PreviewLand>>;

Step preview_step(const Job& job, const Frame& frame, const SharedLand& shared) {
    const render::Style style = *job.request.preview;
    const std::string file =
        fmt::format("frames/{}.{}.png", frame.camera.name, name_of(style));
    const auto key = [&job, frame, style] {
        KeyBuilder builder("preview");
        builder.add(job.program).add(frame.land.key).add(ocio_hash());
        builder.add(style).add(job.request.quality).add(frame.scene->render_text);
        add_to(builder, frame);
        return builder.key();
    };
    const auto natural = [shared](const render::Shot& shot, const Terrain& terrain) {
        if (!*shared) shared->emplace(shot, terrain);
        return (*shared)->frame(shot);
    };
    const auto run = [&job, frame, file, style, natural](Graph&) -> StepResult {
        make_folder(job.folder / "frames");
        const auto land = job.land.drawn();
        const render::Shot shot =
            shot_of(frame.camera, *frame.scene, job.request.quality, *land);
        render::ColourOptions colour = frame.scene->render.colour;
        colour.exposure += frame.camera.exposure;
        write_png(job.folder / file,
                  style == render::Style::kNatural
                      ? render::picture_of(natural(shot, *land), colour)
                      : render::diagram(shot, *land, style));
        return {{file}};
    };
    return {.id = preview_id(job, frame.camera.name),
            .memory = memory::of_passes(job.drawn_cells(), pixels_of(frame.camera)),
            .key = key,
            .run = run,
            .writes = [file] { return std::vector{file}; }};
}

}  // namespace

std::string preview_id(const Job& job, const std::string& frame) {
    return fmt::format("preview {} {}", frame, name_of(*job.request.preview));
}

std::vector<Step> preview_steps(const Job& job) {
    if (!job.request.preview) return {};
    const auto shared = std::make_shared<std::optional<render::PreviewLand>>();
    std::vector<Step> steps;
    for (const Frame& still : stills_of(job))
        steps.push_back(preview_step(job, still, shared));
    return steps;
}

}  // namespace cydonia
