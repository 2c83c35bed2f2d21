#include "render/frames/povray.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <string_view>
#include <system_error>
#include <vector>

#include "field/error.h"
#include "field/files.h"
#include "render/frames/child.h"
#include "render/frames/program.h"
#include "render/frames/trace_progress.h"
#include "render/scene/files.h"

namespace cydonia::render {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kKeptOutput = 64u << 10;  // bytes of its last output that are kept
constexpr std::size_t kLongestMessage = 600;

// The files that POV-Ray writes until the picture is complete; removed when done.
class Unfinished {
  public:
    Unfinished(const fs::path& folder, const std::string& name)
        : picture_(folder / file_of(name, ShotFile::kUnfinishedFrame)),
          state_(folder / file_of(name, ShotFile::kUnfinishedState)) {
        remove();
    }
    ~Unfinished() { remove(); }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    const fs::path& picture() const { return picture_; }

  private:
    void remove() {
        std::error_code none;
        fs::remove(picture_, none);
        fs::remove(state_, none);
    }
    fs::path picture_, state_;
};

// The last output of POV-Ray, without its progress reports.
class LastWords {
  public:
    void add(std::string_view line) {
        text_.append(line).push_back('\n');
        if (text_.size() > kKeptOutput) text_.erase(0, text_.size() - kKeptOutput);
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

std::string_view trimmed(std::string_view line) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == line.npos) return {};
    return line.substr(begin, line.find_last_not_of(" \t") - begin + 1);
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const auto end = std::min(text.find('\n', begin), text.size());
        if (const auto line = trimmed(text.substr(begin, end - begin)); !line.empty())
            lines.push_back(line);
        begin = end + 1;
    }
    return lines;
}

// Lines that POV-Ray prints with every failure and that give no reason.
bool is_no_reason(std::string_view line) {
    return line == "Render failed" || line.starts_with("Fatal error in parser") ||
           line.find("povray.conf") != line.npos;
}

// POV-Ray's own message on one line: from the first line that names an error, or else the
// last three lines. POV-Ray wraps messages at 80 columns.
std::string reason_in(std::string_view text) {
    std::vector<std::string_view> lines = lines_of(text);
    std::erase_if(lines, is_no_reason);
    auto first = std::find_if(lines.begin(), lines.end(), [](std::string_view line) {
        return line.find("Error:") != line.npos || line.starts_with("Fatal error") ||
               line.starts_with("Cannot") || line.starts_with("Problem with");
    });
    if (first == lines.end()) first -= std::min<std::ptrdiff_t>(3, lines.size());

    std::string reason;
    for (; first != lines.end() && reason.size() < kLongestMessage; ++first)
        reason.append(reason.empty() ? "" : " ").append(*first);
    return reason.empty() ? "it did not say why" : reason.substr(0, kLongestMessage);
}

// POV-Ray aborts without a message, or leaves half a picture, when the disk is full.
void expect_space(const fs::path& folder) {
    constexpr std::uintmax_t kLeast = 1u << 20;
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (!error && space.available < kLeast)
        throw failure(
            "the disk of {} is full: make space; the same command goes on from here",
            folder.string());
}

void expect_success(int outcome, const fs::path& scene, std::string_view text) {
    if (outcome != 0) expect_space(scene.parent_path());
    if (outcome == Child::kCannotStart && text.empty())
        throw failure("cannot start POV-Ray in {}", scene.parent_path().string());
    if (outcome < 0)
        throw failure("POV-Ray was killed by signal {} ({}) while it rendered {}{}",
                      -outcome, strsignal(-outcome), scene.string(),
                      -outcome == SIGKILL ? "; the memory may have run out" : "");
    if (outcome != 0)
        throw failure("POV-Ray could not render {}: {}", scene.string(), reason_in(text));
}

std::string in_words(std::chrono::seconds limit) {
    const auto seconds = limit.count();
    return seconds % 60 == 0 ? fmt::format("{} min", seconds / 60)
                             : fmt::format("{} s", seconds);
}

}  // namespace

fs::path povray_program() {
    if (const auto program = program_on_path("povray")) return *program;
    throw failure(
        "no povray on the PATH; install it: apt install povray povray-includes");
}

void run_povray(const fs::path& folder, const std::string& name, int threads,
                std::chrono::seconds time_limit, Progress& progress) {
    const fs::path scene = folder / file_of(name, ShotFile::kScene);
    const Unfinished unfinished(folder, name);
    std::error_code none;
    TraceProgress trace(fs::exists(scene, none) ? read_text(scene) : "");
    LastWords words;

    const auto begun = std::chrono::steady_clock::now();
    const auto listen = [&](std::string& output) {
        const std::chrono::duration<double> seconds =
            std::chrono::steady_clock::now() - begun;
        take_lines(output, [&](std::string_view line) {
            if (!trace.hear(line, seconds.count())) words.add(line);
        });
        progress.report(trace.fraction());
    };
    // +FE: write an EXR whatever the .ini says; +V: report progress; -D: open no window.
    const auto outcome = outcome_of(povray_program(),
                                    {"./" + file_of(name, ShotFile::kSettings), "+FE",
                                     "+O" + unfinished.picture().filename().string(),
                                     fmt::format("+WT{}", threads), "+V", "-D", "-P"},
                                    folder, time_limit, listen);
    if (!outcome)
        throw failure("POV-Ray was stopped: {} took longer than {}", scene.string(),
                      in_words(time_limit));
    expect_success(*outcome, scene, words.text());

    std::error_code error;
    fs::rename(unfinished.picture(), folder / file_of(name, ShotFile::kFrame), error);
    if (error)
        throw failure("POV-Ray ended without a picture of {}: {}", scene.string(),
                      reason_in(words.text()));
    progress.report(1.0);
}

}  // namespace cydonia::render
