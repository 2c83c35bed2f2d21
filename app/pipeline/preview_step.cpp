// A look at the scene in a second: frames by Embree (render/embree) in place of all that
// POV-Ray needs.
#include <fmt/core.h>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "field/files.h"
#include "render/embree/diagram.h"
#include "render/embree/preview_frame.h"
#include "render/frames/frame.h"

namespace cydonia {

Step preview_step(Job& job, const render::CameraOptions& camera) {
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
    const auto run = [&job, camera, file, style]() -> Made {
        make_folder(job.folder / "frames");
        const Terrain& terrain = job.land.drawn();
        const render::Shot shot = shot_of(camera, job, job.spec, terrain);
        render::ColourOptions colour = job.spec.render.colour;
        colour.exposure += camera.exposure;
        write_png(job.folder / file,
                  style == render::Style::kNatural
                      ? render::picture_of(render::preview_frame(shot, terrain), colour)
                      : render::diagram(shot, terrain, style));
        return {{file}};
    };
    return {.name = fmt::format("preview {} {}", camera.name, name_of(style)),
            .goal = Goal::kFrames,
            .memory = memory::of_passes(job.drawn_cells(), pixels),
            .key = key,
            .run = run};
}

std::string_view name_of(render::Style style) {
    constexpr std::string_view kNames[] = {"natural", "grey",     "height",  "slope",
                                           "ink",     "contours", "radiance"};
    return kNames[static_cast<int>(style)];
}

}  // namespace cydonia
