#pragma once

#include <filesystem>
#include <string>

#include "field/progress.h"

namespace cydonia::render {

// A sequence of numbered PNGs in `folder`: <name>-0001.png and so on.
struct Film {
    std::filesystem::path folder;
    std::string name;
    int count = 0;
    double rate = 24.0;  // frames a second
    int still = 0;       // the frame that is held, counted from 0
    double hold = 0.0;   // for how many seconds more than one frame
};

// The path of `ffmpeg`. Throws failure(), naming the package to install.
std::filesystem::path ffmpeg_program();

// Encodes a film with ffmpeg, without a shell. The file's extension chooses the format:
// .mp4 is H.264 (yuv420p, Rec. 709; odd sizes are padded with a black line); .webp and
// .gif are small animations, at most 480 pixels wide. Throws failure() with ffmpeg's own
// message and then leaves no file.
void encode_video(const Film& film, const std::filesystem::path& file,
                  Progress& progress);

}  // namespace cydonia::render
