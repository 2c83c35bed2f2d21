// Frames are traced several at once, each by a POV-Ray of one thread: what it does alone,
// its start and the reading of the land, then runs beside the others (1.6 times as fast
// on 2 cores at draft quality), and one thread draws equal pixels every time. What a
// frame is made from is in the ledger as for any frame, so that none is made twice.
#include "app/sequence/filming.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "app/pipeline/memory.h"
#include "app/sequence/plan.h"
#include "app/sequence/share.h"
#include "app/sequence/sites.h"
#include "app/threads.h"
#include "field/files.h"
#include "render/colour/exposure.h"
#include "render/frames/frame.h"

namespace cydonia {
namespace {

// The trace is nearly all that takes time.
constexpr double kOfTrace = 0.95;

// Whether there was anything to do.
bool finish(const Step& step, Job& job) {
    using Clock = std::chrono::steady_clock;
    const std::uint64_t key = step.key();
    if (job.ledger.finished(step.name, key)) return false;
    const Clock::time_point begin = Clock::now();
    Made made = step.run();
    const std::chrono::duration<double> seconds = Clock::now() - begin;
    job.ledger.record(
        step.name,
        {key, std::move(made.outputs), {}, std::move(made.result), seconds.count(), 0});
    return true;
}

class Filming {
  public:
    Filming(Job& job, const Sequence& sequence)
        : job_(job),
          sequence_(sequence),
          sites_(job),
          share_(sequence.shots.size(), job.progress),
          progress_(progress_of(sequence.shots.size(), share_)),
          traced_(sequence.shots.size(), 0) {}

    // First those whose light tells the exposure of all.
    void run(const std::vector<std::size_t>& frames, int workers) {
        sites_.remove_leftovers();
        leave_out_all_but(frames);
        const auto trace_it = [&](std::size_t i) { trace(i); };
        if (job_.request.trace_only) return each(frames, workers, trace_it);
        each(sequence_.exposed_by, workers, trace_it);
        std::vector<double> own;
        for (const std::size_t i : sequence_.exposed_by)
            own.push_back(render::own_exposure(picture(sequence_.shots[i])));
        exposure_ = sequence_.exposure + render::steady_stops(std::move(own));

        each(frames, workers, [&](std::size_t i) {
            trace(i);
            deliver(i);
        });
    }

    bool is_traced(std::size_t index) {
        return std::ranges::all_of(trace_steps(index), [&](const Step& step) {
            return job_.ledger.finished(step.name, step.key()) != nullptr;
        });
    }

  private:
    static std::vector<FrameProgress> progress_of(std::size_t frames, Share& share) {
        std::vector<FrameProgress> progress;
        for (std::size_t i = 0; i < frames; ++i)
            progress.emplace_back(i, kOfTrace, share);
        return progress;
    }

    // Several at once; the first failure ends them all.
    template <class Work>
    void each(const std::vector<std::size_t>& frames, int workers, const Work& work) {
        std::atomic<std::size_t> next = 0;
        std::exception_ptr error;
        std::mutex mutex;
        const auto go_on = [&] {
            for (std::size_t i = next++; i < frames.size() && !share_.stopped();
                 i = next++) {
                try {
                    work(frames[i]);
                } catch (...) {
                    const std::scoped_lock lock(mutex);
                    if (!error) error = std::current_exception();
                    share_.stop();
                }
            }
        };
        {
            std::vector<std::jthread> threads;
            for (int i = 0; i < workers; ++i) threads.emplace_back(go_on);
        }
        if (error) std::rethrow_exception(error);
    }

    void leave_out_all_but(const std::vector<std::size_t>& frames) {
        std::vector<char> wanted(sequence_.shots.size(), 0);
        for (const std::size_t i : frames) wanted[i] = 1;
        if (!job_.request.trace_only)
            for (const std::size_t i : sequence_.exposed_by) wanted[i] = 1;
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (!wanted[i]) share_.skip(i);
    }

    std::filesystem::path picture(const Shot& shot) const {
        return job_.folder / "pov" / (shot.camera.name + ".exr");
    }

    FrameOf frame_of(std::size_t index) {
        const Shot& shot = sequence_.shots[index];
        FrameOf frame{.camera = sequence_.camera,
                      .when = shot.when,
                      .threads = 1,
                      .progress = &progress_[index],
                      .exposure = exposure_,
                      .moments = shot.moments};
        sites_.choose(shot, frame);
        return frame;
    }

    // Of a land of its own nothing but the light is kept.
    std::vector<Step> trace_steps(std::size_t index) {
        const render::CameraOptions& camera = sequence_.shots[index].camera;
        const FrameOf frame = frame_of(index);
        if (frame.site) return {trace_step_at_site(job_, camera, frame)};
        return {shot_step(job_, camera, frame), frame_steps(job_, camera, frame).front()};
    }

    void trace(std::size_t index) {
        if (traced_[index]) return;
        progress_[index].report(0.0);
        bool anew = false;
        for (const Step& step : trace_steps(index)) anew = finish(step, job_);
        traced_[index] = 1;
        if (anew)
            share_.report(index, kOfTrace);
        else
            share_.skip(index);
    }

    void deliver(std::size_t index) {
        const Shot& shot = sequence_.shots[index];
        const FrameOf frame = frame_of(index);
        finish(deliver_step(job_, shot.camera, frame), job_);
        if (job_.spec.render.passes)
            finish(passes_step(job_, shot.camera, frame, shot.next), job_);
        share_.finish(index);
    }

    Job& job_;
    const Sequence& sequence_;
    Sites sites_;
    Share share_;
    std::vector<FrameProgress> progress_;  // of each frame
    std::vector<char> traced_;             // in this run or before
    std::optional<double> exposure_;       // EV, once it is known
};

// As many as have a core and fit into memory.
int workers_for(const Job& job, const Sequence& sequence) {
    const render::CameraOptions& camera = sequence.shots.front().camera;
    const std::uint64_t each = memory::of_trace(
        job.drawn_cells(), static_cast<std::uint64_t>(camera.size[0]) *
                               static_cast<std::uint64_t>(camera.size[1]));
    const std::uint64_t fit = std::max<std::uint64_t>(1, memory::available() / each);
    const std::uint64_t most = std::min<std::uint64_t>(fit, sequence.shots.size());
    return static_cast<int>(
        std::min<std::uint64_t>(most, static_cast<std::uint64_t>(thread_count())));
}

}  // namespace

Made film_by_povray(Job& job, const Sequence& sequence) {
    make_folder(job.folder / "pov");
    job.land.drawn();  // once, before workers share it
    const std::vector<std::size_t> frames = frames_to_make(sequence, job.request);
    Filming(job, sequence).run(frames, workers_for(job, sequence));
    Made made;
    const auto add_outputs_of = [&](const std::string& step) {
        for (std::string& file : job.ledger.outputs_of(step))
            made.outputs.push_back(std::move(file));
    };
    for (const std::size_t i : frames) {
        const std::string& frame = sequence.shots[i].camera.name;
        if (job.request.trace_only) {
            add_outputs_of("trace " + frame);
            continue;
        }
        add_outputs_of("deliver " + frame);
        if (job.spec.render.passes) add_outputs_of("passes " + frame);
    }
    return made;
}

std::vector<std::size_t> frames_to_trace(Job& job, const Sequence& sequence) {
    std::vector<std::size_t> frames = frames_to_make(sequence, job.request);
    frames.insert(frames.end(), sequence.exposed_by.begin(), sequence.exposed_by.end());
    std::ranges::sort(frames);
    frames.erase(std::ranges::unique(frames).begin(), frames.end());
    Filming filming(job, sequence);
    std::erase_if(frames, [&](std::size_t i) { return filming.is_traced(i); });
    return frames;
}

}  // namespace cydonia
