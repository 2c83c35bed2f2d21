// A sequence by Embree, to be looked at while working: one frame after the other, each on
// all cores.
#include <fmt/core.h>

#include <map>
#include <optional>

#include "app/pipeline/cache.h"
#include "app/sequence/filming.h"
#include "app/sequence/plan.h"
#include "app/sequence/sites.h"
#include "field/files.h"
#include "render/colour/exposure.h"
#include "render/embree/diagram.h"
#include "render/embree/preview_frame.h"
#include "render/frames/frame.h"

namespace cydonia {
namespace {

class Looking {
  public:
    Looking(Job& job, const Sequence& sequence, render::Style style)
        : job_(job), sequence_(sequence), style_(style), sites_(job) {}

    Made run() {
        make_folder(job_.folder / "frames");
        if (style_ == render::Style::kNatural) expose();
        Made made;
        const std::vector<std::size_t> frames = frames_to_make(sequence_, job_.request);
        for (const std::size_t i : frames) {
            made.outputs.push_back(frame(i));
            job_.progress.report(static_cast<double>(made.outputs.size()) /
                                 static_cast<double>(frames.size()));
        }
        return made;
    }

  private:
    void expose() {
        std::vector<double> own;
        for (const std::size_t i : sequence_.exposed_by)
            own.push_back(render::own_exposure(natural(sequence_.shots[i])));
        exposure_ = sequence_.exposure + render::steady_stops(std::move(own));
    }

    // What all shots of one scene share is made once.
    Field<Rgb> natural(const Shot& shot) {
        const FrameOf frame = frame_of(shot);
        const auto site = site_of(job_, frame);
        const render::Shot drawn =
            shot_of(shot.camera, job_, scene_of(job_, frame), site->terrain);
        if (!land_ || shot.scene) land_.emplace(drawn, site->terrain);
        return land_->frame(drawn);
    }

    FrameOf frame_of(const Shot& shot) {
        FrameOf frame{.camera = sequence_.camera};
        sites_.choose(shot, frame);
        return frame;
    }

    Field<Rgb8> picture(const Shot& shot) {
        if (style_ == render::Style::kNatural) {
            render::ColourOptions colour = job_.spec.render.colour;
            colour.exposure += shot.camera.exposure;
            return render::picture_of(natural(shot), colour, exposure_);
        }
        const FrameOf frame = frame_of(shot);
        const auto site = site_of(job_, frame);
        return render::diagram(
            shot_of(shot.camera, job_, scene_of(job_, frame), site->terrain),
            site->terrain, style_);
    }

    // Made unless it is there; gives its file.
    std::string frame(std::size_t index) {
        const Shot& shot = sequence_.shots[index];
        const FrameOf of = frame_of(shot);
        const std::string name =
            frame_name(fmt::format("{}-{}", sequence_.name, name_of(style_)),
                       static_cast<int>(index));
        const std::string file = "frames/" + name + ".png";
        const std::uint64_t key = hash_text(fmt::format(
            "look {:016x} {:016x} {:016x} {} {} {} {}\n{}",
            of.site ? of.land : job_.land.key(), job_.program, ocio_hash(),
            text_of(shot.camera, of), name_of(style_), name_of(job_.request.quality),
            exposure_.value_or(0.0), scene_of(job_, of).render_text));
        if (job_.ledger.finished("look " + name, key)) return file;
        write_png(job_.folder / file, picture(shot));
        job_.ledger.record("look " + name, {.key = key, .outputs = {file}});
        return file;
    }

    Job& job_;
    const Sequence& sequence_;
    render::Style style_;
    Sites sites_;
    std::optional<render::PreviewLand> land_;
    std::optional<double> exposure_;  // EV, of natural frames
};

}  // namespace

Made film_by_embree(Job& job, const Sequence& sequence, render::Style style) {
    return Looking(job, sequence, style).run();
}

}  // namespace cydonia
