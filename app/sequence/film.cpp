// Frames are traced several at once, each by a POV-Ray of one thread: what it does alone,
// its start and the reading of the land, then runs beside the others (1.6 times as fast
// on 2 cores at draft quality), and one thread draws equal pixels every time. What a
// frame is made from is in the ledger as for any frame, so that none is made twice.
#include "app/sequence/film.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <mutex>
#include <numeric>
#include <thread>

#include "app/pipeline/cache.h"
#include "app/pipeline/memory.h"
#include "app/pipeline/shadow_report.h"
#include "app/sequence/day.h"
#include "app/threads.h"
#include "field/error.h"
#include "field/files.h"
#include "render/frames/frame.h"
#include "render/frames/povray.h"
#include "render/frames/video.h"

namespace cydonia {
namespace {

// How far all frames are, together. The first failure stops every worker.
class Share {
  public:
    Share(std::size_t frames, Progress& progress)
        : fractions_(frames, 0.0), progress_(progress) {}

    void report(std::size_t frame, double fraction) {
        if (stopped_) throw Interrupted{};
        const std::scoped_lock lock(mutex_);
        fractions_[frame] = fraction;
        const double sum = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
        const std::size_t frames = fractions_.size() - skipped_;
        progress_.report(frames ? sum / static_cast<double>(frames) : 1.0);
    }
    // A frame that was traced before is no work, and no measure of the time left.
    void skip(std::size_t frame) {
        const std::scoped_lock lock(mutex_);
        fractions_[frame] = 0.0;
        ++skipped_;
    }
    // Of the error under way.
    void fail() {
        const std::scoped_lock lock(mutex_);
        if (!error_) error_ = std::current_exception();
        stopped_ = true;
    }
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

  private:
    std::mutex mutex_;
    std::vector<double> fractions_;
    std::size_t skipped_ = 0;
    Progress& progress_;
    std::exception_ptr error_;
    std::atomic<bool> stopped_ = false;
};

// One frame's part of it.
class FrameProgress final : public Progress {
  public:
    FrameProgress(std::size_t frame, Share& share) : frame_(frame), share_(share) {}
    void step(std::string_view) override {}
    // The trace is all that takes time.
    void report(double fraction) override { share_.report(frame_, 0.95 * fraction); }
    void note(std::string_view) override {}
    void warn(std::string_view) override {}

  private:
    std::size_t frame_;
    Share& share_;
};

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

// Shots in the order of work: the one that gives all others their exposure first.
std::vector<std::size_t> order_of(const Sequence& sequence) {
    std::vector<std::size_t> order(sequence.shots.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = order.begin() + sequence.key_shot;
    std::rotate(order.begin(), key, key + 1);
    return order;
}

class Filming {
  public:
    Filming(Job& job, const Sequence& sequence)
        : job_(job),
          sequence_(sequence),
          order_(order_of(sequence)),
          share_(order_.size(), job.progress),
          exposure_(key_exposed_.get_future()) {}

    void run(int workers) {
        {
            std::vector<std::jthread> threads;
            for (int i = 0; i < workers; ++i) threads.emplace_back([this] { work(); });
        }
        share_.rethrow();
    }

  private:
    void work() {
        for (std::size_t i = next_++; i < order_.size(); i = next_++) {
            try {
                make(order_[i]);
            } catch (...) {
                share_.fail();
                if (i == 0 && !exposed_)  // or the others would wait for ever
                    key_exposed_.set_exception(std::current_exception());
                return;
            }
        }
    }

    void make(std::size_t index) {
        const Shot& shot = sequence_.shots[index];
        const bool is_key = index == static_cast<std::size_t>(sequence_.key_shot);
        FrameProgress progress(index, share_);
        progress.report(0.0);
        const FrameOf frame{.camera = sequence_.camera,
                            .when = shot.when,
                            .threads = 1,
                            .progress = &progress,
                            .exposure = [this] { return exposure_.get(); }};
        finish(shot_step(job_, shot.camera, frame), job_);
        const std::vector<Step> steps = frame_steps(job_, shot.camera, frame);
        const bool traced = finish(steps.front(), job_);
        if (is_key) expose_by(shot);
        finish(steps.back(), job_);
        if (traced)
            share_.report(index, 1.0);
        else
            share_.skip(index);
    }

    void expose_by(const Shot& key) {
        key_exposed_.set_value(
            sequence_.exposure +
            render::own_exposure(job_.folder / "pov" / (key.camera.name + ".exr")));
        exposed_ = true;
    }

    Job& job_;
    const Sequence& sequence_;
    const std::vector<std::size_t> order_;
    Share share_;
    std::promise<double> key_exposed_;
    bool exposed_ = false;  // of the key shot's worker
    std::shared_future<double> exposure_;
    std::atomic<std::size_t> next_ = 0;
};

std::uint64_t pixels_of(const render::CameraOptions& camera) {
    return static_cast<std::uint64_t>(camera.size[0]) *
           static_cast<std::uint64_t>(camera.size[1]);
}

// As many as have a core and fit into memory.
int workers_for(const Job& job, const Sequence& sequence) {
    const std::uint64_t each =
        memory::of_trace(job.drawn_cells(), pixels_of(sequence.shots.front().camera));
    const std::uint64_t fit = std::max<std::uint64_t>(1, memory::available() / each);
    const std::uint64_t most = std::min<std::uint64_t>(fit, sequence.shots.size());
    return static_cast<int>(
        std::min<std::uint64_t>(most, static_cast<std::uint64_t>(thread_count())));
}

render::CameraOptions camera_of(const Job& job) {
    return filming_camera(job.spec.frames, job.cameras());
}

// The suns that stages chose are in the terrain.
Day day_of(Job& job) {
    return day_over(job.spec.frames, camera_of(job), job.land.finished().shadows);
}

Json json_of(const Day& day) {
    Json shots = Json::array();
    for (const Shot& shot : day.sequence.shots) {
        shots.push_back({{"frame", shot.camera.name},
                         {"when", shot.when},
                         {"sun", json_of(*shot.camera.sun)}});
    }
    const Shot& key =
        day.sequence.shots.at(static_cast<std::size_t>(day.sequence.key_shot));
    return {{"camera", day.sequence.camera},
            {"news", day.news},
            {"appears", day.appears},
            {"key_frame", key.camera.name},
            {"shots", std::move(shots)}};
}

void tell(const Json& day, Progress& progress) {
    for (const Json& sentence : day.at("news")) {
        const auto text = sentence.get<std::string>();
        if (text.find("does not appear") == text.npos)
            progress.note(text);
        else
            progress.warn(text);
    }
}

Made film(Job& job) {
    const Sequence sequence = day_of(job).sequence;
    job.land.drawn();  // once, before workers share it
    Filming(job, sequence).run(workers_for(job, sequence));
    Made made;
    for (const Shot& shot : sequence.shots) {
        made.outputs.push_back("frames/" + shot.camera.name + ".exr");
        made.outputs.push_back("frames/" + shot.camera.name + ".png");
    }
    return made;
}

Made encode(Job& job) {
    const Sequence sequence = day_of(job).sequence;
    const render::Film film{
        job.folder / "frames", sequence.name,     static_cast<int>(sequence.shots.size()),
        sequence.rate,         sequence.key_shot, sequence.hold};
    Made made;
    for (const char* extension : {".mp4", ".webp"}) {
        made.outputs.push_back("frames/" + sequence.name + extension);
        render::encode_video(film, job.folder / made.outputs.back(), job.progress);
    }
    return made;
}

std::uint64_t key_of(const Job& job, const std::string& what) {
    const render::ColourOptions& colour = job.spec.render.colour;
    return hash_text(fmt::format(
        "{} {:016x} {:016x} {} {} {} {:016x} {}\n{}\n{}", what, job.land.key(),
        job.program, name_of(job.request.quality), job.spec.title, job.spec.name,
        ocio_hash(), colour.config ? colour.config->hash : 0, job.spec.render_text,
        job.spec.frames_text));
}

// The frames are worth having without it, and the user waits for them already.
void look_for_ffmpeg(Progress& progress) try {
    render::ffmpeg_program();
} catch (const Error& error) {
    progress.warn(fmt::format("{}; the frames are made, the video is not", error.what()));
}

}  // namespace

std::vector<Step> day_steps(Job& job) {
    const std::uint64_t pixels = pixels_of(camera_of(job));
    const std::uint64_t tracing = std::max(memory::of_emit(job.drawn_cells()),
                                           memory::of_trace(job.drawn_cells(), pixels));
    return {{.name = "plan day",
             .goal = Goal::kSweep,
             .memory = memory::of_export(job.cells()),
             .key = [&job] { return key_of(job, "plan"); },
             .run =
                 [&job] {
                     return Made{{}, json_of(day_of(job))};
                 },
             .gate = [&job](const Json& day) { tell(day, job.progress); },
             .before = [&job] { check_day(job.spec); }},
            {.name = "film day",
             .goal = Goal::kSweep,
             .memory = tracing,
             .key = [&job] { return key_of(job, "film"); },
             .run = [&job] { return film(job); },
             .before = [] { render::povray_program(); }},
            {.name = "video day",
             .goal = Goal::kSweep,
             .memory = memory::of_delivery(pixels),
             .key = [&job] { return key_of(job, "video"); },
             .run = [&job] { return encode(job); },
             .before = [&job] { look_for_ffmpeg(job.progress); }}};
}

}  // namespace cydonia
