// Previews of a sequence by Embree, one frame after another, each on all cores.
#include <fmt/core.h>

#include <optional>

#include "app/pipeline/steps.h"
#include "app/sequence/film_lands.h"
#include "app/sequence/filming.h"
#include "app/sequence/plan.h"
#include "field/files.h"
#include "render/colour/exposure.h"
#include "render/embree/diagram.h"
#include "render/embree/preview_frame.h"
#include "render/frames/frame.h"

namespace cydonia {
namespace {

class Looking {
  public:
    Looking(const Job& job, const Sequence& sequence, render::Style style, Graph& graph)
        : job_(job), sequence_(sequence), style_(style), graph_(graph), lands_(job) {}

    StepResult run() {
        make_folder(job_.folder / "frames");
        if (style_ == render::Style::kNatural) expose();
        StepResult made;
        const std::vector<std::size_t> frames = frames_to_make(sequence_, job_.request);
        for (const std::size_t i : frames) {
            Graph steps({look_step(i)}, graph_.ledger());
            made.outputs.push_back(steps.finish(steps.steps().front()).record.outputs[0]);
            job_.progress.report(static_cast<double>(made.outputs.size()) /
                                 static_cast<double>(frames.size()));
        }
        return made;
    }

  private:
    void expose() {
        std::vector<double> own;
        for (const std::size_t i : sequence_.exposed_by)
            own.push_back(render::own_exposure(natural(frame_of(i))));
        exposure_ = sequence_.exposure + render::steady_stops(std::move(own));
    }

    Frame frame_of(std::size_t index) {
        const SequenceFrame& frame = sequence_.frames[index];
        return {.camera = frame.camera,
                .view = sequence_.camera,
                .when = frame.when,
                .scene = frame.scene ? frame.scene : job_.spec,
                .land = lands_.of(frame),
                .exposure = exposure_,
                .progress = &job_.progress};
    }

    render::Shot shot_of_frame(const Frame& frame, const Terrain& land) const {
        return shot_of(frame.camera, *frame.scene, job_.request.quality, land);
    }

    // What all frames of the same scene share is made once.
    Field<Rgb> natural(const Frame& frame) {
        const auto site = frame.land.site();
        const render::Shot shot = shot_of_frame(frame, *site->terrain);
        if (!shared_ || frame.scene != job_.spec) shared_.emplace(shot, *site->terrain);
        return shared_->frame(shot);
    }

    Field<Rgb8> picture(const Frame& frame) {
        if (style_ == render::Style::kNatural) {
            render::ColourOptions colour = job_.spec->render.colour;
            colour.exposure += frame.camera.exposure;
            return render::picture_of(natural(frame), colour, exposure_);
        }
        const auto site = frame.land.site();
        return render::diagram(shot_of_frame(frame, *site->terrain), *site->terrain,
                               style_);
    }

    Key key_of(const Frame& frame) const {
        KeyBuilder key("look");
        key.add(job_.program).add(frame.land.key).add(ocio_hash());
        key.add(style_).add(job_.request.quality).add(exposure_);
        key.add(frame.scene->render_text);
        add_to(key, frame);
        return key.key();
    }

    Step look_step(std::size_t index) {
        const std::string file =
            file_of_look(sequence_.name, style_, static_cast<int>(index));
        const Frame frame = frame_of(index);
        const auto run = [this, frame, file](Graph&) -> StepResult {
            write_png(job_.folder / file, picture(frame));
            return {{file}};
        };
        return {.id = "look " + std::filesystem::path(file).stem().string(),
                .key = [this, frame] { return key_of(frame); },
                .run = run};
    }

    const Job& job_;
    const Sequence& sequence_;
    render::Style style_;
    Graph& graph_;
    FilmLands lands_;
    std::optional<render::PreviewLand> shared_;
    std::optional<double> exposure_;  // EV, of natural frames
};

}  // namespace

StepResult film_by_embree(const Job& job, const Sequence& sequence, render::Style style,
                          Graph& graph) {
    return Looking(job, sequence, style, graph).run();
}

std::string file_of_look(const std::string& sequence, render::Style style, int index) {
    const std::string reel = fmt::format("{}-{}", sequence, name_of(style));
    return "frames/" + frame_name(reel, index) + ".png";
}

}  // namespace cydonia
