#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <system_error>

#include "app/pipeline/cache.h"
#include "app/pipeline/job.h"
#include "app/pipeline/memory.h"
#include "app/threads.h"
#include "field/error.h"
#include "field/files.h"
#include "render/frames/frame.h"
#include "render/frames/povray.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

// A frame is traced (costly) from what the emit step wrote, byte for byte, and delivered
// (cheap) with the scene's colour options: exposure and view change without a new trace.

std::chrono::seconds time_limit(render::Quality quality) {
    switch (quality) {
        case render::Quality::kDraft:
            return std::chrono::minutes(30);
        case render::Quality::kPreview:
            return std::chrono::hours(4);
        case render::Quality::kFinal:
            break;
    }
    return std::chrono::hours(48);
}

std::uint64_t trace_key(const Job& job, const std::string& frame) {
    std::string text = "trace";
    for (const std::string& step : {std::string(kAssetsStep), shot_step_name(frame)}) {
        for (const std::string& file : job.ledger.outputs_of(step)) {
            text += fmt::format(" {:016x}", hash_of_file(job.folder / file));
        }
    }
    return hash_text(text);
}

// A picture that POV-Ray cut short without a word (a full disk) is no picture.
void expect_whole(const fs::path& picture) try {
    read_exr_rgb(picture);
} catch (const Error& error) {
    std::error_code none;
    fs::remove(picture, none);
    throw failure("POV-Ray left half a picture: {}", error.what());
}

Made trace(Job& job, const std::string& frame, const FrameOf& of) {
    render::run_povray(
        job.folder / "pov", frame, of.threads ? of.threads : thread_count(),
        time_limit(job.request.quality), of.progress ? *of.progress : job.progress);
    expect_whole(job.folder / "pov" / (frame + ".exr"));
    return {{"pov/" + frame + ".exr"}};
}

// The scene's, with the camera's own exposure added.
render::ColourOptions colour_of(const Job& job, const render::CameraOptions& camera) {
    render::ColourOptions colour = job.spec.render.colour;
    colour.exposure += camera.exposure;
    return colour;
}

std::uint64_t delivery_key(const Job& job, const std::string& frame,
                           const render::ColourOptions& colour, const FrameOf& of) {
    return hash_text(
        fmt::format("{:016x} {:016x} {:016x} {:016x} {} {} {} {} {} {} {} {}",
                    hash_of_file(job.folder / "pov" / (frame + ".exr")), job.program,
                    colour.config ? colour.config->hash : 0, ocio_hash(), colour.display,
                    colour.view, colour.exposure, job.spec.name, job.spec.seed, of.camera,
                    of.when, of.exposure ? fmt::format("{}", of.exposure()) : "its own"));
}

Made deliver(Job& job, const std::string& frame, const render::ColourOptions& colour,
             const FrameOf& of) {
    make_folder(job.folder / "frames");
    Metadata metadata = job.metadata();
    metadata["cydonia:camera"] = of.camera.empty() ? frame : of.camera;
    if (!of.when.empty()) metadata["cydonia:when"] = of.when;
    metadata["cydonia:quality"] = name_of(job.request.quality);
    render::deliver_frame(job.folder / "pov" / (frame + ".exr"), job.folder / "frames",
                          frame, colour, metadata,
                          of.exposure ? std::optional(of.exposure()) : std::nullopt);
    return {{"frames/" + frame + ".exr", "frames/" + frame + ".png"}};
}

// At most, whatever the quality: render::place makes smaller frames of drafts.
std::uint64_t pixels_of(const render::CameraOptions& camera) {
    return static_cast<std::uint64_t>(camera.size[0]) *
           static_cast<std::uint64_t>(camera.size[1]);
}

}  // namespace

std::string_view name_of(render::Quality quality) {
    constexpr std::string_view kNames[] = {"draft", "preview", "final"};
    return kNames[static_cast<int>(quality)];
}

std::uint64_t ocio_hash() {
    const char* ocio = std::getenv("OCIO");
    return ocio ? hash_of_file(ocio) : 0;
}

std::vector<Step> frame_steps(Job& job, const render::CameraOptions& camera,
                              const FrameOf& of) {
    const std::string frame = camera.name;
    const std::uint64_t pixels = pixels_of(camera);
    const render::ColourOptions colour = colour_of(job, camera);
    return {
        {.name = "trace " + frame,
         .goal = Goal::kFrames,
         .memory = memory::of_trace(job.drawn_cells(), pixels),
         .key = [&job, frame] { return trace_key(job, frame); },
         .run = [&job, frame, of] { return trace(job, frame, of); },
         .before = [] { render::povray_program(); }},
        {.name = "deliver " + frame,
         .goal = Goal::kFrames,
         .memory = memory::of_delivery(pixels),
         .key = [&job, frame, colour,
                 of] { return delivery_key(job, frame, colour, of); },
         .run = [&job, frame, colour, of] { return deliver(job, frame, colour, of); }}};
}

}  // namespace cydonia
