#pragma once

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <vector>

#include "field/progress.h"

namespace cydonia {

// The progress of all frames of a sequence together. Any thread may report.
class Share {
  public:
    Share(std::size_t frames, Progress& progress)
        : fractions_(frames, 0.0), skipped_(frames, false), progress_(progress) {}

    void report(std::size_t frame, double fraction) {
        if (stopped_) throw Interrupted{};
        const std::scoped_lock lock(mutex_);
        if (!skipped_[frame]) fractions_[frame] = fraction;
        const double sum = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
        const auto frames = std::count(skipped_.begin(), skipped_.end(), false);
        progress_.report(frames ? sum / static_cast<double>(frames) : 1.0);
    }
    // Leaves out a frame that was made before: it would distort the time left.
    void skip(std::size_t frame) {
        const std::scoped_lock lock(mutex_);
        fractions_[frame] = 0.0;
        skipped_[frame] = true;
    }
    void finish(std::size_t frame) { report(frame, 1.0); }
    // The next report of any thread throws Interrupted.
    void stop() { stopped_ = true; }
    bool stopped() const { return stopped_; }

  private:
    std::mutex mutex_;
    std::vector<double> fractions_;
    std::vector<bool> skipped_;
    Progress& progress_;
    std::atomic<bool> stopped_ = false;
};

// The progress of one frame, which goes up to `most`.
class FrameProgress final : public Progress {
  public:
    FrameProgress(std::size_t frame, double most, Share& share)
        : frame_(frame), most_(most), share_(share) {}
    void step(std::string_view) override {}
    void report(double fraction) override { share_.report(frame_, most_ * fraction); }
    void note(std::string_view) override {}
    void warn(std::string_view) override {}

  private:
    std::size_t frame_;
    double most_;
    Share& share_;
};

}  // namespace cydonia
