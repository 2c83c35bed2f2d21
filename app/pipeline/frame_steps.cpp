#include <fmt/core.h>

#include <chrono>
#include <cstdlib>
#include <system_error>

#include "app/pipeline/memory.h"
#include "app/pipeline/pictures.h"
#include "app/pipeline/steps.h"
#include "field/error.h"
#include "field/files.h"
#include "field/rgb.h"
#include "render/frames/frame.h"
#include "render/frames/povray.h"
#include "render/scene/files.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

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

// POV-Ray does not always say so when it cuts a picture short, as on a full disk. Such a
// picture is removed.
Field<Rgb> whole_picture(const fs::path& picture) try {
    return read_exr_rgb(picture);
} catch (const Error& error) {
    std::error_code none;
    fs::remove(picture, none);
    throw failure("POV-Ray wrote an incomplete picture: {}", error.what());
}

// The progress of a frame while one of its pictures is traced.
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

// Of pictures in linear light.
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

// The light of a picture, as POV-Ray's folder has it.
std::string light_file(const std::string& picture) {
    return render::file_of(picture, render::ShotFile::kFrame);
}

// Traces all pictures of a frame in `folder`; their mean is the frame's light there.
void trace_pictures(const Job& job, const fs::path& folder, const Frame& frame) {
    const std::vector<render::CameraOptions> pictures = pictures_of(frame);
    Mean mean;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        PartProgress part(i, pictures.size(), *frame.progress);
        const std::string& name = pictures[i].name;
        render::run_povray(folder, name, frame.threads, time_limit(job.request.quality),
                           part);
        const Field<Rgb> picture = whole_picture(folder / light_file(name));
        if (frame.moments.empty()) return;
        mean.add(picture);
        std::error_code none;
        fs::remove(folder / light_file(name), none);
    }
    write_exr(folder / light_file(frame.camera.name), std::move(mean).get());
}

std::string light_of(const Frame& frame) {
    return "pov/" + light_file(frame.camera.name);
}

std::vector<std::string> delivered_files(const Frame& frame) {
    return {"frames/" + frame.camera.name + ".exr",
            "frames/" + frame.camera.name + ".png"};
}

// The scene's colour options with the camera's exposure added.
render::ColourOptions colour_of(const Job& job, const Frame& frame) {
    render::ColourOptions colour = job.spec->render.colour;
    colour.exposure += frame.camera.exposure;
    return colour;
}

Key delivery_key(const Job& job, const Frame& frame) {
    const render::ColourOptions colour = colour_of(job, frame);
    return KeyBuilder("deliver")
        .add(job.program)
        .add(colour.config ? colour.config->hash : 0)
        .add(ocio_hash())
        .add(colour.display)
        .add(colour.view)
        .add(colour.exposure)
        .add(job.spec->name)
        .add(job.spec->seed)
        .add(frame.view)
        .add(frame.when)
        .add(frame.exposure)
        .key();
}

StepResult deliver(const Job& job, const Frame& frame) {
    make_folder(job.folder / "frames");
    Metadata metadata = job.metadata();
    metadata["cydonia:camera"] = frame.view;
    if (!frame.when.empty()) metadata["cydonia:when"] = frame.when;
    metadata["cydonia:quality"] = name_of(job.request.quality);
    render::deliver_frame(job.folder / light_of(frame), job.folder / "frames",
                          frame.camera.name, colour_of(job, frame), metadata,
                          frame.exposure);
    return {delivered_files(frame)};
}

}  // namespace

std::uint64_t ocio_hash() {
    const char* ocio = std::getenv("OCIO");
    return ocio ? hash_of_file(ocio) : 0;
}

std::string trace_id(const std::string& frame) { return "trace " + frame; }
std::string deliver_id(const std::string& frame) { return "deliver " + frame; }

Step trace_step(const Job& job, const Frame& frame) {
    const auto run = [&job, frame](Graph&) -> StepResult {
        trace_pictures(job, job.folder / "pov", frame);
        return {{light_of(frame)}};
    };
    return {.id = trace_id(frame.camera.name),
            .memory = memory::of_trace(job.drawn_cells(), pixels_of(frame.camera)),
            .key = [] { return KeyBuilder("trace").key(); },
            .run = run,
            .before = [] { render::povray_program(); },
            .writes = [frame] { return std::vector{light_of(frame)}; }};
}

Step trace_temporary_land_step(const Job& job, const Frame& frame) {
    const auto key = [&job, frame] {
        KeyBuilder builder("trace of a temporary land");
        builder.add(job.program).add(job.request.quality).add(frame.land.key);
        builder.add(frame.scene->title).add(frame.scene->render_text);
        add_to(builder, frame);
        return builder.key();
    };
    const auto run = [&job, frame](Graph&) -> StepResult {
        const auto site = frame.land.site();
        write_pictures(job, *site, frame);
        trace_pictures(job, site->pov, frame);
        fs::rename(site->pov / light_file(frame.camera.name),
                   job.folder / light_of(frame));
        return {{light_of(frame)}};
    };
    return {.id = trace_id(frame.camera.name),
            .memory = memory::of_trace(job.drawn_cells(), pixels_of(frame.camera)),
            .key = key,
            .run = run};
}

Step deliver_step(const Job& job, const Frame& frame) {
    return {.id = deliver_id(frame.camera.name),
            .memory = memory::of_delivery(pixels_of(frame.camera)),
            .key = [&job, frame] { return delivery_key(job, frame); },
            .run = [&job, frame](Graph&) { return deliver(job, frame); },
            .writes = [frame] { return delivered_files(frame); }};
}

}  // namespace cydonia
