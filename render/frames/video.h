#pragma once

#include <filesystem>
#include <string>

#include "field/progress.h"

namespace cydonia::render {

// Numbered PNGs in a row: <name>-0001.png and so on, in `folder`.
struct Film {
    std::filesystem::path folder;
    std::string name;
    int count = 0;
    double rate = 24.0;  // frames a second
    int still = 0;       // the frame, from 0, on which the film stands still
    double hold = 0.0;   // seconds, besides the frame's own
};

// Where `ffmpeg` is, or a failure() that names the package to install.
std::filesystem::path ffmpeg_program();

// Runs ffmpeg without a shell. What it makes goes by the file's extension: .mp4 is H.264
// (yuv420p, Rec. 709; a black line pads odd sizes), .webp and .gif are small pictures
// that move, at most 480 pixels wide. On failure throws ffmpeg's own words; nothing
// half-written keeps the name.
void encode_video(const Film& film, const std::filesystem::path& file,
                  Progress& progress);

}  // namespace cydonia::render
