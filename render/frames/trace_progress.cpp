#include "render/frames/trace_progress.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <system_error>

namespace cydonia::render {
namespace {

// Each grid of the pretrace has four times as many points as the one before, and POV-Ray
// counts points. A pass takes less than four times as long, because finer grids reuse
// more samples. The shares of time were measured on scenes/text and scenes/coast.
constexpr double kCounts[] = {1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0};
constexpr double kShares[] = {0.035, 0.10, 0.35, 0.515};
// The trace takes about kCost * n^1.4 times as long as the pretrace, where n pixels lie
// between two points of the finest grid. The exponent is below 2 because neighbouring
// pixels of a large frame differ less and need less antialiasing.
constexpr double kCostGrowth = 1.4;
constexpr double kCost = 0.4;      // land seen from the side, partly in haze
constexpr double kFineCost = 1.3;  // land seen from above or strewn with things

constexpr std::size_t kStrips = 32;
constexpr std::size_t kLeastReports = 12;  // fewer cannot tell strips apart
constexpr double kIdle = 0.15;      // strips below this share of the mean time are sky
constexpr double kIdleTime = 0.03;  // weight of a strip of sky; all others have 1
constexpr double kUnfinished = 0.995;

std::optional<double> number_at(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), number);
    if (error != std::errc()) return std::nullopt;
    return number;
}

std::optional<double> number_after(std::string_view text, std::string_view word) {
    const auto at = text.find(word);
    return at == text.npos ? std::nullopt : number_at(text.substr(at + word.size()));
}

// "Rendered 1024 of 307200 pixels (0%)"
std::optional<double> count_of(std::string_view line) {
    constexpr std::string_view kRendered = "Rendered ";
    if (!line.starts_with(kRendered)) return std::nullopt;
    const auto done = number_at(line.substr(kRendered.size()));
    const auto all = number_after(line, " of ");
    if (!done || !all || *all <= 0.0) return std::nullopt;
    return std::clamp(*done / *all, 0.0, 1.0);
}

// The share of a pass's time that has passed at `share` of its strips.
double time_at(const std::vector<double>& strips, double share) {
    if (strips.empty()) return share;
    const double at = share * static_cast<double>(kStrips);
    const auto whole = std::min(static_cast<std::size_t>(at), kStrips - 1);
    const double before = std::accumulate(strips.begin(), strips.begin() + whole, 0.0);
    return (before + (at - static_cast<double>(whole)) * strips[whole]) /
           std::accumulate(strips.begin(), strips.end(), 0.0);
}

}  // namespace

TraceProgress::TraceProgress(std::string_view pov)
    : has_radiosity_(pov.find("radiosity {") != pov.npos) {
    if (!has_radiosity_) {
        passes_ = {{1.0, 0.0, 1.0, 0.0, {}}};
        return;
    }
    pretrace_end_ = number_after(pov, "pretrace_end ").value_or(pretrace_end_);
    const bool is_fine =
        pov.find("orthographic") != pov.npos || pov.find(".things.inc\"\n") != pov.npos;
    pixel_cost_ = is_fine ? kFineCost : kCost;
    double from = 0.0;
    for (std::size_t i = 0; i < std::size(kCounts); ++i) {
        passes_.push_back({kShares[i], from, kCounts[i], 0.0, {}});
        from = kCounts[i];
    }
    passes_.push_back({pixel_cost_, 0.0, 1.0, 0.0, {}});
}

// "  Image resolution.....640 by 360 (rows 1 to 360, columns 1 to 640)."
void TraceProgress::set_image(std::string_view line) {
    constexpr std::string_view kSize = "Image resolution";
    const auto at = line.find(kSize);
    if (at == line.npos || !has_radiosity_) return;
    line.remove_prefix(at + kSize.size());
    line.remove_prefix(std::min(line.find_first_not_of('.'), line.size()));
    if (const auto width = number_at(line))
        passes_.back().expected =
            pixel_cost_ * std::pow(pretrace_end_ * *width, kCostGrowth);
}

bool TraceProgress::hear(std::string_view line, double seconds) {
    const auto count = count_of(line);
    if (!count) {
        set_image(line);
        return false;
    }
    if (!has_radiosity_) {
        fraction_ = std::max(fraction_, *count);
        return true;
    }
    if (passes_[0].reports.empty()) passes_[0].begun = seconds;
    const std::size_t trace = passes_.size() - 1;
    const bool begins_anew = counted_ > 0.9 && *count < 0.5;
    if (begins_anew) go_to(trace, seconds);
    counted_ = *count;
    while (current_ + 1 < trace && *count > passes_[current_].to + 0.002)
        go_to(current_ + 1, seconds);

    Pass& pass = passes_[current_];
    const double share =
        std::clamp((*count - pass.from) / (pass.to - pass.from), 0.0, 1.0);
    // Lines that arrive together are one report.
    if (!pass.reports.empty() && seconds - pass.reports.back().seconds < 0.05)
        pass.reports.back().share = std::max(pass.reports.back().share, share);
    else
        pass.reports.push_back({share, seconds});

    const double rest = left(share, seconds);
    if (rest < 0.0) return true;
    // A quick beginning does not mean that the end is near, so the estimate is capped.
    double expected = 0.0, all = 0.0;
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        all += passes_[i].expected;
        if (i < current_) expected += passes_[i].expected;
    }
    expected += time_at(strips_, share) * pass.expected;
    fraction_ = std::max(fraction_, std::min({seconds / (seconds + rest),
                                              2.0 * expected / all, kUnfinished}));
    return true;
}

void TraceProgress::go_to(std::size_t pass, double seconds) {
    strips_ = strips_of(passes_[current_], seconds);
    for (++current_; current_ < pass; ++current_) passes_[current_].begun = seconds;
    passes_[current_].begun = seconds;
}

// Strips of sky take almost no time; all others take about the same time.
TraceProgress::Strips TraceProgress::strips_of(const Pass& pass, double ended) {
    if (pass.reports.size() < kLeastReports || ended <= pass.begun) return {};
    Strips strips(kStrips, 0.0);
    double at = 0.0, seconds = pass.begun;
    for (const Pass::Report& report : pass.reports) {
        const double from = at * kStrips, to = report.share * kStrips;
        const auto first = std::min(static_cast<std::size_t>(from), kStrips - 1);
        const auto last = std::min(static_cast<std::size_t>(to), kStrips - 1);
        for (std::size_t i = first; i <= last && to > from; ++i) {
            const double low = std::max(from, static_cast<double>(i));
            const double high = std::min(to, static_cast<double>(i + 1));
            strips[i] += (report.seconds - seconds) * (high - low) / (to - from);
        }
        at = std::max(at, report.share);
        seconds = report.seconds;
    }
    const double mean = (seconds - pass.begun) / kStrips;
    for (double& strip : strips) strip = strip > kIdle * mean ? 1.0 : kIdleTime;
    return strips;
}

// The estimated seconds left, or a negative number while nothing is known.
double TraceProgress::left(double share, double seconds) const {
    const Pass& pass = passes_[current_];
    double expected_before = 0.0, expected_after = 0.0;
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        if (i < current_) expected_before += passes_[i].expected;
        if (i > current_) expected_after += passes_[i].expected;
    }
    const double before = pass.begun - passes_[0].begun, gone = seconds - pass.begun;
    if (before <= 0.0) return -1.0;
    // The expected time of the rest of the pass, at the pace of the passes before.
    const double done = time_at(strips_, share);
    const double whole = gone + (1.0 - done) * pass.expected * before / expected_before;
    const double pace = (before + whole) / (expected_before + pass.expected);
    return std::max(0.0, whole - gone) + expected_after * pace;
}

}  // namespace cydonia::render
