#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

#include "field/progress.h"

namespace cydonia {

// The program's only Progress sink. It writes to standard error: a bar with the time left
// on a terminal, plain lines in a log, nothing when quiet. Any thread may report.
class Console final : public Progress {
  public:
    enum class Style { kBar, kLines, kQuiet };

    explicit Console(Style style) : style_(style) {}
    ~Console() override { finish(); }

    void step(std::string_view name) override;
    void report(double fraction) override;
    void figure(std::string_view text) override;
    void note(std::string_view sentence) override;
    void warn(std::string_view sentence) override;

    // Ends the last step's line.
    void finish();

  private:
    using Clock = std::chrono::steady_clock;

    void end_step();
    void draw(double fraction, double elapsed);
    void print_above(const std::string& line);

    const Style style_;
    std::mutex mutex_;
    std::string name_;    // of the running step; empty between steps
    std::string figure_;  // the last one the step reported
    Clock::time_point begun_;
    std::atomic<Clock::rep> next_{0};  // when to draw again
    bool bar_drawn_ = false;
};

// kBar on a terminal, kLines elsewhere.
Console::Style style_for_stderr(bool quiet);

// "0.42 s", "1 min 12 s", "3 h 05 min".
std::string duration_text(double seconds);

}  // namespace cydonia
