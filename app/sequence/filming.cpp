// Frames are traced several at once, each by a POV-Ray of one thread. What POV-Ray does
// on one core, starting and reading the land, then runs beside other frames' traces (1.6
// times as fast on 2 cores at draft quality), and one thread draws equal pixels every
// time. A frame's steps are those of a still, and the ledger knows them by the same keys.
#include "app/sequence/filming.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "app/pipeline/memory.h"
#include "app/pipeline/steps.h"
#include "app/sequence/film_lands.h"
#include "app/sequence/plan.h"
#include "app/sequence/share.h"
#include "app/threads.h"
#include "field/files.h"
#include "render/colour/exposure.h"
#include "render/frames/frame.h"

namespace cydonia {
namespace {

// The share of a frame's time that its trace takes.
constexpr double kOfTrace = 0.95;

class Filming {
  public:
    Filming(const Job& job, const Sequence& sequence, Graph& graph)
        : job_(job),
          sequence_(sequence),
          graph_(graph),
          lands_(job),
          share_(sequence.frames.size(), job.progress),
          progress_(progress_of(sequence.frames.size(), share_)),
          traced_(sequence.frames.size(), 0) {}

    // Frames whose light determines the exposure of all come first.
    void run(const std::vector<std::size_t>& frames, int workers) {
        lands_.remove_leftovers();
        leave_out_all_but(frames);
        const auto trace_it = [&](std::size_t i) { trace(i); };
        if (job_.request.trace_only) return each(frames, workers, trace_it);
        each(sequence_.exposed_by, workers, trace_it);
        std::vector<double> own;
        for (const std::size_t i : sequence_.exposed_by)
            own.push_back(render::own_exposure(light_of(sequence_.frames[i])));
        exposure_ = sequence_.exposure + render::steady_stops(std::move(own));

        each(frames, workers, [&](std::size_t i) {
            trace(i);
            deliver(i);
        });
    }

    bool is_traced(std::size_t index) {
        return steps_of_frame(index).finished(trace_id(name_of_frame(index)));
    }

  private:
    static std::vector<FrameProgress> progress_of(std::size_t frames, Share& share) {
        std::vector<FrameProgress> progress;
        for (std::size_t i = 0; i < frames; ++i)
            progress.emplace_back(i, kOfTrace, share);
        return progress;
    }

    // Works on several frames at once; the first failure stops all workers.
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
        std::vector<char> wanted(sequence_.frames.size(), 0);
        for (const std::size_t i : frames) wanted[i] = 1;
        if (!job_.request.trace_only)
            for (const std::size_t i : sequence_.exposed_by) wanted[i] = 1;
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (!wanted[i]) share_.skip(i);
    }

    const std::string& name_of_frame(std::size_t index) const {
        return sequence_.frames[index].camera.name;
    }

    std::filesystem::path light_of(const SequenceFrame& frame) const {
        return job_.folder / "pov" / (frame.camera.name + ".exr");
    }

    // The exposure may not be known yet; only the delivery depends on it.
    Graph steps_of_frame(std::size_t index) {
        const SequenceFrame& frame = sequence_.frames[index];
        return {frame_steps(job_, {.camera = frame.camera,
                                   .moments = frame.moments,
                                   .next = frame.next,
                                   .view = sequence_.camera,
                                   .when = frame.when,
                                   .scene = frame.scene ? frame.scene : job_.spec,
                                   .land = lands_.of(frame),
                                   .exposure = exposure_,
                                   .threads = 1,
                                   .progress = &progress_[index]}),
                graph_.ledger(), &graph_};
    }

    void trace(std::size_t index) {
        if (traced_[index]) return;
        progress_[index].report(0.0);
        Graph steps = steps_of_frame(index);
        bool is_new = false;
        for (const Step* step : steps.closure({trace_id(name_of_frame(index))}))
            is_new |= steps.finish(*step).is_new;
        traced_[index] = 1;
        if (is_new)
            share_.report(index, kOfTrace);
        else
            share_.skip(index);
    }

    // The frame has been traced.
    void deliver(std::size_t index) {
        Graph steps = steps_of_frame(index);
        for (const Step& step : steps.steps()) steps.finish(step);
        share_.finish(index);
    }

    const Job& job_;
    const Sequence& sequence_;
    Graph& graph_;  // with the steps of the land
    FilmLands lands_;
    Share share_;
    std::vector<FrameProgress> progress_;  // of each frame
    std::vector<char> traced_;             // by this run or an earlier one
    std::optional<double> exposure_;       // EV; none until it is known
};

// One for each core, but no more than fit into memory.
int workers_for(const Job& job, const Sequence& sequence) {
    const std::uint64_t each =
        memory::of_trace(job.drawn_cells(), pixels_of(sequence.frames.front().camera));
    const std::uint64_t fit = std::max<std::uint64_t>(1, memory::available() / each);
    const std::uint64_t most = std::min<std::uint64_t>(fit, sequence.frames.size());
    return static_cast<int>(
        std::min<std::uint64_t>(most, static_cast<std::uint64_t>(thread_count())));
}

}  // namespace

StepResult film_by_povray(const Job& job, const Sequence& sequence, Graph& graph) {
    make_folder(job.folder / "pov");
    const std::vector<std::size_t> frames = frames_to_make(sequence, job.request);
    Filming(job, sequence, graph).run(frames, workers_for(job, sequence));
    StepResult made;
    const auto add_outputs_of = [&](const std::string& step) {
        for (std::string& file : graph.ledger().outputs_of(step))
            made.outputs.push_back(std::move(file));
    };
    for (const std::size_t i : frames) {
        const std::string& frame = sequence.frames[i].camera.name;
        if (job.request.trace_only) {
            add_outputs_of(trace_id(frame));
            continue;
        }
        add_outputs_of(deliver_id(frame));
        if (job.spec->render.passes) add_outputs_of(passes_id(frame));
    }
    return made;
}

std::vector<std::size_t> frames_to_trace(const Job& job, const Sequence& sequence,
                                         Graph& graph) {
    std::vector<std::size_t> frames = frames_to_make(sequence, job.request);
    frames.insert(frames.end(), sequence.exposed_by.begin(), sequence.exposed_by.end());
    std::ranges::sort(frames);
    frames.erase(std::ranges::unique(frames).begin(), frames.end());
    Filming filming(job, sequence, graph);
    std::erase_if(frames, [&](std::size_t i) { return filming.is_traced(i); });
    return frames;
}

}  // namespace cydonia
