#include "app/console.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "app/interrupt.h"

namespace cydonia {
namespace {

constexpr int kBarWidth = 16;
constexpr double kBarEvery = 0.1;    // seconds between redraws
constexpr double kLineEvery = 10.0;  // seconds between lines in a log
constexpr double kNoticed = 0.05;    // seconds; shorter steps print no line

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
        .count();
}

// Empty below 2%, where the estimate would be wrong by far.
std::string time_left(double fraction, double elapsed) {
    if (fraction < 0.02) return "";
    return ", " + duration_text(elapsed * (1.0 - fraction) / fraction) + " left";
}

void put(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace

void Console::step(std::string_view name) {
    const std::scoped_lock lock(mutex_);
    end_step();
    name_ = name;
    figure_.clear();
    begun_ = Clock::now();
    next_ = 0;
    if (style_ == Style::kBar) draw(0.0, 0.0);
    if (style_ == Style::kLines) {
        const auto first = begun_ + std::chrono::duration<double>(kLineEvery);
        next_ = std::chrono::time_point_cast<Clock::duration>(first)
                    .time_since_epoch()
                    .count();
    }
}

void Console::report(double fraction) {
    if (interrupt_signal() != 0) throw Interrupted{};
    const Clock::time_point now = Clock::now();
    if (style_ == Style::kQuiet || now.time_since_epoch().count() < next_) return;

    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || name_.empty()) return;
    const std::chrono::duration<double> every(style_ == Style::kBar ? kBarEvery
                                                                    : kLineEvery);
    next_ = (now + std::chrono::duration_cast<Clock::duration>(every))
                .time_since_epoch()
                .count();
    draw(std::clamp(fraction, 0.0, 1.0), seconds_since(begun_));
}

void Console::figure(std::string_view text) {
    const std::scoped_lock lock(mutex_);
    figure_ = fmt::format(", {}", text);
}

void Console::note(std::string_view sentence) {
    const std::scoped_lock lock(mutex_);
    print_above(fmt::format("  {}\n", sentence));
}

void Console::warn(std::string_view sentence) {
    const std::scoped_lock lock(mutex_);
    print_above(fmt::format("  warning: {}\n", sentence));
}

void Console::finish() {
    const std::scoped_lock lock(mutex_);
    end_step();
}

void Console::end_step() {
    if (name_.empty()) return;
    const double seconds = seconds_since(begun_);
    print_above(seconds < kNoticed
                    ? ""
                    : fmt::format("{:<40} {:>10}\n", name_, duration_text(seconds)));
    name_.clear();
}

void Console::draw(double fraction, double elapsed) {
    const std::string left = time_left(fraction, elapsed) + figure_;
    if (style_ == Style::kLines) {
        put(fmt::format("{}: {:.0f}%{}\n", name_, 100.0 * fraction, left));
        return;
    }
    const int full = static_cast<int>(std::lround(fraction * kBarWidth));
    put(fmt::format("\r\033[K{:<40} [{:#<{}}{:.<{}}] {:3.0f}%{}", name_, "", full, "",
                    kBarWidth - full, 100.0 * fraction, left));
    bar_drawn_ = true;
}

void Console::print_above(const std::string& line) {
    if (style_ == Style::kQuiet) return;
    put((bar_drawn_ ? "\r\033[K" : "") + line);
    bar_drawn_ = false;
}

Console::Style style_for_stderr(bool quiet) {
    if (quiet) return Console::Style::kQuiet;
    const char* terminal = std::getenv("TERM");
    const bool can_draw = terminal && std::string_view(terminal) != "dumb";
    return can_draw && isatty(STDERR_FILENO) ? Console::Style::kBar
                                             : Console::Style::kLines;
}

std::string duration_text(double seconds) {
    if (seconds < 9.995) return fmt::format("{:.2f} s", seconds);
    const long whole = std::lround(seconds);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace cydonia
