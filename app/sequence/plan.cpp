#include "app/sequence/plan.h"

#include <numeric>

#include "app/sequence/day.h"
#include "app/sequence/timeline.h"
#include "app/sequence/turntable.h"
#include "field/error.h"

namespace cydonia {
namespace {

// If the scene does not say how many frames there are, those asked for are the last ones.
config::FramesSpec frames_of(const Job& job) {
    config::FramesSpec frames = job.spec->frames;
    if (!frames.count && job.request.frames) frames.count = job.request.frames->last + 1;
    return frames;
}

// A turntable may have a camera of its own, which has no size from the request yet.
Sequence sized(Sequence sequence, const Job& job) {
    for (SequenceFrame& frame : sequence.frames) {
        job.resize(frame.camera);
        job.resize(*frame.next);
        for (render::CameraOptions& moment : frame.moments) job.resize(moment);
    }
    return sequence;
}

}  // namespace

Goal goal_of(Kind kind) {
    switch (kind) {
        case Kind::kDay:
            return Goal::kSweep;
        case Kind::kTurntable:
            return Goal::kTurntable;
        case Kind::kFilm:
            break;
    }
    return Goal::kFilm;
}

std::optional<Kind> sequence_of(Goal goal) {
    for (const Kind kind : {Kind::kDay, Kind::kTurntable, Kind::kFilm})
        if (goal_of(kind) == goal) return kind;
    return std::nullopt;
}

SequencePlan plan_of(Kind kind, const Job& job) {
    switch (kind) {
        case Kind::kDay: {
            Day day =
                day_over(frames_of(job), filming_camera(job.spec->frames, job.cameras()),
                         job.land.finished()->shadows);
            return {std::move(day.sequence), std::move(day.messages), day.appears};
        }
        case Kind::kTurntable:
            return {sized(turntable(frames_of(job), job.cameras()), job)};
        case Kind::kFilm:
            break;
    }
    Timeline film = timeline({[&job](double frame) { return job.at(frame); },
                              job.scene.varies(), job.scene.last_key()},
                             *job.spec, job.cameras());
    return {std::move(film.sequence), std::move(film.messages)};
}

int check_plan(Kind kind, const Job& job) {
    if (kind == Kind::kDay) check_day(*job.spec);
    const int count = kind == Kind::kFilm
                          ? static_cast<int>(plan_of(kind, job).sequence.frames.size())
                          : frames_of(job).count.value_or(config::FramesSpec::kCount);
    if (const auto& asked = job.request.frames; asked && asked->last >= count)
        throw bad_request("--frames {}-{}: the {} has {} frames, 0 to {}", asked->first,
                          asked->last, name_of(kind), count, count - 1);
    return count;
}

std::vector<std::size_t> frames_to_make(const Sequence& sequence,
                                        const Request& request) {
    std::vector<std::size_t> frames(sequence.frames.size());
    if (request.frames)
        frames.resize(
            static_cast<std::size_t>(request.frames->last - request.frames->first + 1));
    std::iota(frames.begin(), frames.end(),
              static_cast<std::size_t>(request.frames ? request.frames->first : 0));
    return frames;
}

}  // namespace cydonia
