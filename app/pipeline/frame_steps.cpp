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
#include "field/rgb.h"
#include "render/frames/frame.h"
#include "render/frames/povray.h"
#include "render/scene/files.h"

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
Field<Rgb> whole(const fs::path& picture) try {
    return read_exr_rgb(picture);
} catch (const Error& error) {
    std::error_code none;
    fs::remove(picture, none);
    throw failure("POV-Ray left half a picture: {}", error.what());
}

// One of several pictures' part of a frame's progress.
class PartProgress final : public Progress {
  public:
    PartProgress(std::size_t part, std::size_t parts, Progress& all)
        : part_(static_cast<double>(part)),
          parts_(static_cast<double>(parts)),
          all_(all) {}
    void step(std::string_view) override {}
    void report(double fraction) override { all_.report((part_ + fraction) / parts_); }
    void note(std::string_view sentence) override { all_.note(sentence); }
    void warn(std::string_view sentence) override { all_.warn(sentence); }

  private:
    double part_, parts_;
    Progress& all_;
};

// Of linear light.
class Mean {
  public:
    void add(const Field<Rgb>& picture) {
        if (sum_.empty()) sum_ = Field<Rgb>(picture.width(), picture.height());
        for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] = sum_[i] + picture[i];
        ++count_;
    }
    Field<Rgb> get() && {
        for (Rgb& pixel : sum_) pixel = (1.0 / count_) * pixel;
        return std::move(sum_);
    }

  private:
    Field<Rgb> sum_;
    int count_ = 0;
};

// As many as the frame has moments; their mean is the frame.
void trace_pictures(const Job& job, const fs::path& folder,
                    const render::CameraOptions& camera, const FrameOf& of) {
    Progress& progress = of.progress ? *of.progress : job.progress;
    const std::vector<render::CameraOptions> pictures = pictures_of(camera, of);
    Mean mean;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        PartProgress part(i, pictures.size(), progress);
        const std::string& name = pictures[i].name;
        render::run_povray(folder, name, of.threads ? of.threads : thread_count(),
                           time_limit(job.request.quality), part);
        const Field<Rgb> picture =
            whole(folder / render::file_of(name, render::ShotFile::kFrame));
        if (of.moments.empty()) return;
        mean.add(picture);
        std::error_code none;
        fs::remove(folder / render::file_of(name, render::ShotFile::kFrame), none);
    }
    write_exr(folder / render::file_of(camera.name, render::ShotFile::kFrame),
              std::move(mean).get());
}

Made trace(Job& job, const render::CameraOptions& camera, const FrameOf& of) {
    trace_pictures(job, job.folder / "pov", camera, of);
    return {{"pov/" + camera.name + ".exr"}};
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
                    of.when, of.exposure ? fmt::format("{}", *of.exposure) : "its own"));
}

Made deliver(Job& job, const std::string& frame, const render::ColourOptions& colour,
             const FrameOf& of) {
    make_folder(job.folder / "frames");
    Metadata metadata = job.metadata();
    metadata["cydonia:camera"] = of.camera.empty() ? frame : of.camera;
    if (!of.when.empty()) metadata["cydonia:when"] = of.when;
    metadata["cydonia:quality"] = name_of(job.request.quality);
    render::deliver_frame(job.folder / "pov" / (frame + ".exr"), job.folder / "frames",
                          frame, colour, metadata, of.exposure);
    return {{"frames/" + frame + ".exr", "frames/" + frame + ".png"}};
}

// At most, whatever the quality: render::place makes smaller frames of drafts.
std::uint64_t pixels_of(const render::CameraOptions& camera) {
    return static_cast<std::uint64_t>(camera.size[0]) *
           static_cast<std::uint64_t>(camera.size[1]);
}

}  // namespace

std::uint64_t ocio_hash() {
    const char* ocio = std::getenv("OCIO");
    return ocio ? hash_of_file(ocio) : 0;
}

std::vector<Step> frame_steps(Job& job, const render::CameraOptions& camera,
                              const FrameOf& of) {
    const std::string frame = camera.name;
    Step trace_step{.name = "trace " + frame,
                    .goal = Goal::kFrames,
                    .memory = memory::of_trace(job.drawn_cells(), pixels_of(camera)),
                    .key = [&job, frame] { return trace_key(job, frame); },
                    .run = [&job, camera, of] { return trace(job, camera, of); },
                    .before = [] { render::povray_program(); }};
    return {std::move(trace_step), deliver_step(job, camera, of)};
}

Step trace_step_at_site(Job& job, const render::CameraOptions& camera,
                        const FrameOf& of) {
    const auto key = [&job, camera, of] {
        const config::SceneSpec& scene = scene_of(job, of);
        return hash_text(fmt::format("at site {:016x} {:016x} {} {} {}\n{}", of.land,
                                     job.program, text_of(camera, of),
                                     name_of(job.request.quality), scene.title,
                                     scene.render_text));
    };
    const auto run = [&job, camera, of]() -> Made {
        const std::string picture = camera.name + ".exr";
        const auto site = site_of(job, of);
        write_pictures(job, *site, camera, of);
        trace_pictures(job, site->pov, camera, of);
        fs::rename(site->pov / picture, job.folder / "pov" / picture);
        return {{"pov/" + picture}};
    };
    return {.name = "trace " + camera.name,
            .goal = Goal::kFrames,
            .memory = memory::of_trace(job.drawn_cells(), pixels_of(camera)),
            .key = key,
            .run = run};
}

Step deliver_step(Job& job, const render::CameraOptions& camera, const FrameOf& of) {
    const std::string frame = camera.name;
    const render::ColourOptions colour = colour_of(job, camera);
    return {
        .name = "deliver " + frame,
        .goal = Goal::kFrames,
        .memory = memory::of_delivery(pixels_of(camera)),
        .key = [&job, frame, colour, of] { return delivery_key(job, frame, colour, of); },
        .run = [&job, frame, colour, of] { return deliver(job, frame, colour, of); }};
}

}  // namespace cydonia
