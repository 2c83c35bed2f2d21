#include "render/frames/video.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>
#include <string_view>
#include <system_error>
#include <vector>

#include "field/error.h"
#include "field/files.h"
#include "render/frames/child.h"
#include "render/frames/program.h"

namespace cydonia::render {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::hours kTimeLimit{2};
constexpr std::size_t kKeptWords = 600;

int held_frames(const Film& film) {
    return static_cast<int>(std::lround(film.hold * film.rate));
}

// Holds the still frame, then applies what the format needs.
std::string filters(const Film& film, std::string_view format) {
    const int held = held_frames(film);
    const std::string loop =
        held > 0 ? fmt::format("loop=loop={}:size=1:start={},", held, film.still) : "";
    // Time stamps are renumbered: the loop leaves a gap that ffmpeg would fill.
    return loop + fmt::format("setpts=N/({}*TB),", film.rate) + std::string(format);
}

// Always two threads: x264 writes other bytes with another number.
std::vector<std::string> as_mp4(const Film& film) {
    return {"-vf",
            filters(film,
                    "pad=ceil(iw/2)*2:ceil(ih/2)*2,"
                    "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"),
            "-c:v", "libx264", "-preset", "slow", "-crf", "18", "-threads", "2",
            // Tells players how the colours are encoded: for sRGB.
            "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc",
            "iec61966-2-1", "-color_range", "tv", "-movflags", "+faststart"};
}

std::vector<std::string> as_webp(const Film& film) {
    return {"-vf",      filters(film, "scale=w='min(480,iw)':h=-1:flags=lanczos"),
            "-c:v",     "libwebp_anim",
            "-quality", "75",
            "-loop",    "0"};
}

// One palette for the whole film, dithered in a pattern that does not move.
std::vector<std::string> as_gif(const Film& film) {
    return {"-vf",
            filters(film,
                    "scale=w='min(480,iw)':h=-1:flags=lanczos,split[film][same];"
                    "[same]palettegen=stats_mode=full[colours];"
                    "[film][colours]paletteuse=dither=bayer:bayer_scale=3"),
            "-loop", "0"};
}

std::vector<std::string> as(const std::string& extension, const Film& film) {
    if (extension == ".mp4") return as_mp4(film);
    return extension == ".gif" ? as_gif(film) : as_webp(film);
}

std::vector<std::string> arguments(const Film& film, const fs::path& file) {
    std::vector<std::string> words{"-nostdin",
                                   "-hide_banner",
                                   "-loglevel",
                                   "error",
                                   "-nostats",
                                   "-progress",
                                   "pipe:1",
                                   "-framerate",
                                   fmt::format("{}", film.rate),
                                   "-start_number",
                                   "1",
                                   "-i",
                                   film.name + "-%04d.png"};
    const auto how = as(file.extension().string(), film);
    words.insert(words.end(), how.begin(), how.end());
    const std::vector<std::string> out{"-an", "-fflags", "+bitexact", "-y",
                                       fs::absolute(file).string()};
    words.insert(words.end(), out.begin(), out.end());
    return words;
}

// Whether a line comes from -progress: "out_time_us=250081".
bool is_report(std::string_view line) {
    const auto equals = line.find('=');
    return line.empty() || (equals != line.npos &&
                            std::ranges::all_of(line.substr(0, equals), [](char c) {
                                return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
                                       c == '_';
                            }));
}

// Takes the frame number from "frame=12". Any line that is no report is an error message.
void hear(std::string_view line, int& frame, std::string& words) {
    constexpr std::string_view kFrame = "frame=";
    if (line.starts_with(kFrame))
        std::from_chars(line.data() + kFrame.size(), line.data() + line.size(), frame);
    else if (!is_report(line) && words.size() < kKeptWords)
        words.append(words.empty() ? "" : " ").append(line);
}

void expect_success(int outcome, const fs::path& file, const std::string& words) {
    if (outcome < 0)
        throw failure("ffmpeg was killed by signal {} ({}) while it made {}", -outcome,
                      strsignal(-outcome), file.string());
    if (outcome != 0)
        throw failure("ffmpeg could not make {}: {}", file.string(),
                      words.empty() ? "it did not say why" : words.substr(0, kKeptWords));
}

// ffmpeg would stop at a missing frame and write a shorter film without an error.
void expect_frames(const Film& film) {
    for (int i = 1; i <= film.count; ++i) {
        const fs::path frame = film.folder / fmt::format("{}-{:04}.png", film.name, i);
        std::error_code none;
        if (!fs::is_regular_file(frame, none))
            throw failure("no video without {}", frame.string());
    }
}

void run_ffmpeg(const Film& film, const fs::path& file, const fs::path& named,
                Progress& progress) {
    const double frames = film.count + held_frames(film);
    std::string words;
    int frame = 0;
    const auto outcome = outcome_of(
        ffmpeg_program(), arguments(film, file), film.folder, kTimeLimit,
        [&](std::string& output) {
            take_lines(output, [&](std::string_view line) { hear(line, frame, words); });
            progress.report(std::clamp(frame / frames, 0.0, 1.0));
        });
    if (!outcome)
        throw failure("ffmpeg was stopped: {} took longer than 2 h", named.string());
    expect_success(*outcome, named, words);
}

}  // namespace

fs::path ffmpeg_program() {
    if (const auto program = program_on_path("ffmpeg")) return *program;
    throw failure("no ffmpeg on the PATH; install it: apt install ffmpeg");
}

void encode_video(const Film& film, const fs::path& file, Progress& progress) {
    expect_frames(film);
    write_atomically(file, [&](const fs::path& temporary) {
        run_ffmpeg(film, temporary, file, progress);
    });
    progress.report(1.0);
}

}  // namespace cydonia::render
