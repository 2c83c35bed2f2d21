#include "app/sketch_frame.h"

#include <fmt/format.h>

#include <optional>

#include "app/pipeline/frame.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/output_folder.h"
#include "app/threads.h"
#include "field/base64.h"
#include "field/error.h"
#include "field/files.h"
#include "field/markup.h"
#include "field/svg_camera.h"
#include "field/svg_paths.h"
#include "render/embree/preview_frame.h"
#include "render/frames/frame.h"
#include "render/maps/hillshade.h"

namespace fs = std::filesystem;

namespace cydonia {
namespace {

constexpr int kQuality = 88;  // of the JPEG to draw over
constexpr int kPlan = 1280;   // pixels of the plan's longer side

// An SVG with the picture on a locked layer and an empty layer above it.
std::string drawing_over(const Field<Rgb8>& picture, const std::string& title,
                         const std::string& metadata) {
    const int w = picture.width(), h = picture.height();
    return fmt::format(
        R"(<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
     xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
     xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
     width="{0}" height="{1}" viewBox="0 0 {0} {1}">
  <title>{2}</title>
  <metadata>{3}</metadata>
  <g id="frame" inkscape:groupmode="layer" inkscape:label="frame" sodipodi:insensitive="true">
    <image width="{0}" height="{1}" preserveAspectRatio="none"
           xlink:href="data:image/jpeg;base64,{4}"/>
  </g>
  <g id="strokes" inkscape:groupmode="layer" inkscape:label="strokes"
     style="fill:none;stroke:#e0007a;stroke-width:2;stroke-linejoin:round">
  </g>
</svg>
)",
        w, h, escaped(title), metadata, base64(jpeg_of(picture, kQuality)));
}

bool has_strokes(const fs::path& file) {
    std::error_code none;
    if (!fs::exists(file, none)) return false;
    try {
        return !svg_paths(open_source(file), 1e-3).empty();
    } catch (const Error&) {
        return true;  // a file that we did not write
    }
}

class Writer {
  public:
    explicit Writer(const Job& job) : job_(job), folder_(job.folder / "sketch") {}

    void refuse_to_overwrite(const std::string& name) const {
        const fs::path file = folder_ / (name + ".svg");
        if (!job_.request.force && has_strokes(file))
            throw bad_request(
                "{} has strokes in it: move it beside the scene, or replace it with "
                "--force",
                file.string());
    }
    void write(const std::string& name, const Field<Rgb8>& picture,
               const std::string& metadata) {
        make_folder(folder_);
        write_text(folder_ / (name + ".svg"),
                   drawing_over(picture, fmt::format("{}, {}", job_.spec->title, name),
                                metadata));
        written_ += fmt::format("{}{}.svg", written_.empty() ? "" : ", ", name);
    }
    const std::string& written() const { return written_; }

  private:
    const Job& job_;
    fs::path folder_;
    std::string written_;
};

void write_all(const Job& job, Console& console) {
    constexpr const char* kPlanName = "plan";
    std::vector<render::CameraOptions> cameras = job.cameras();
    std::erase_if(cameras, [](const render::CameraOptions& camera) {
        return camera.kind == render::CameraOptions::Kind::kOverhead;
    });
    Writer writer(job);
    writer.refuse_to_overwrite(kPlanName);
    std::uint64_t pixels = 0;
    for (const render::CameraOptions& camera : cameras) {
        writer.refuse_to_overwrite(camera.name);
        pixels = std::max(pixels, pixels_of(camera));
    }
    memory::refuse_unless_it_fits(memory::of_passes(job.drawn_cells(), pixels),
                                  memory::available());

    const Field<Rgb8> plan = render::hillshade(*job.land.finished(), kPlan);
    console.step("frames to draw over");
    writer.write(kPlanName, plan, "");
    std::optional<render::PreviewLand> land;
    for (const render::CameraOptions& camera : cameras) {
        const auto drawn = job.land.drawn();
        const render::Shot shot = shot_of(camera, *job.spec, job.request.quality, *drawn);
        if (!land) land.emplace(shot, *drawn);
        render::ColourOptions colour = job.spec->render.colour;
        colour.exposure += camera.exposure;
        writer.write(camera.name, render::picture_of(land->frame(shot), colour),
                     svg_camera_text(shot.camera));
    }
    console.finish();
    console.note(fmt::format("{} in {}: keep a copy beside the scene and draw in it",
                             writer.written(), (job.folder / "sketch").string()));
}

}  // namespace

void frame_for_sketch(const Request& request, Console& console) {
    with_threads(request.threads, [&] {
        const Job job(request, console);
        const OutputFolder claim(job.folder);
        claim.belongs_to(job.spec->name);
        write_all(job, console);
    });
}

}  // namespace cydonia
