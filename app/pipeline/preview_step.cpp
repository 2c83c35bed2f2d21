// A look at the scene in a second: frames by Embree (render/embree) in place of all that
// POV-Ray needs.
#include <fmt/core.h>

#include <memory>
#include <optional>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "field/files.h"
#include "render/embree/diagram.h"
#include "render/embree/preview_frame.h"
#include "render/frames/frame.h"

namespace cydonia {
namespace {

// What the cameras of a scene share, made by the first of them.
using SharedLand = std::shared_ptr<std::optional<render::PreviewLand>>;

Step preview_step(Job& job, const render::CameraOptions& camera, const SharedLand& land) {
    const render::Style style = *job.request.preview;
    const std::string file = fmt::format("frames/{}.{}.png", camera.name, name_of(style));
    const auto pixels = static_cast<std::uint64_t>(camera.size[0]) *
                        static_cast<std::uint64_t>(camera.size[1]);
    const auto key = [&job, camera, file] {
        return hash_text(fmt::format("preview {:016x} {:016x} {:016x} {} {} {}\n{}",
                                     job.land.key(), job.program, ocio_hash(),
                                     text_of(camera, {}), file,
                                     name_of(job.request.quality), job.spec.render_text));
    };
    const auto natural = [land](const render::Shot& shot, const Terrain& terrain) {
        if (!*land) land->emplace(shot, terrain);
        return (*land)->frame(shot);
    };
    const auto run = [&job, camera, file, style, natural]() -> Made {
        make_folder(job.folder / "frames");
        const Terrain& terrain = job.land.drawn();
        const render::Shot shot = shot_of(camera, job, job.spec, terrain);
        render::ColourOptions colour = job.spec.render.colour;
        colour.exposure += camera.exposure;
        write_png(job.folder / file,
                  style == render::Style::kNatural
                      ? render::picture_of(natural(shot, terrain), colour)
                      : render::diagram(shot, terrain, style));
        return {{file}};
    };
    return {.name = fmt::format("preview {} {}", camera.name, name_of(style)),
            .goal = Goal::kFrames,
            .memory = memory::of_passes(job.drawn_cells(), pixels),
            .key = key,
            .run = run};
}

}  // namespace

std::vector<Step> preview_steps(Job& job) {
    const auto land = std::make_shared<std::optional<render::PreviewLand>>();
    std::vector<Step> steps;
    for (const render::CameraOptions& camera : job.cameras())
        steps.push_back(preview_step(job, camera, land));
    return steps;
}

}  // namespace cydonia
