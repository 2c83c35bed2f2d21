#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/reader/scene.h"
#include "render/options.h"

namespace cydonia {

// A frame of a sequence; Frame (app/pipeline/frame.h) is made of it.
struct SequenceFrame {
    render::CameraOptions camera;  // its name is that of the frame
    std::string when = {};         // for the frame's metadata: "17:42 (UTC+2)"
    // The camera at moments while the shutter is open; empty: the shutter is instant.
    std::vector<render::CameraOptions> moments = {};
    // The camera one frame later, for motion vectors; none: it does not move.
    std::optional<render::CameraOptions> next = {};
    // The scene at this frame; null: it does not vary in time and is the job's.
    std::shared_ptr<const config::SceneSpec> scene = {};
};

// Frames, and the video of them.
struct Sequence {
    std::string name;    // "day": the video is called so, its frames "day-0001" ...
    std::string camera;  // the scene's camera that films
    std::vector<SequenceFrame> frames;
    // All frames have the same exposure: the median of what these frames would get.
    std::vector<std::size_t> exposed_by;
    double exposure = 0.0;  // EV, added to that
    double rate = 24.0;     // frames a second
    int still = 0;          // the frame at which the video pauses, from 0
    double hold = 0.0;      // length of the pause, seconds
};

// What moves in a sequence: the sun, the camera around the land, or whatever has keys and
// paths in the scene.
enum class Kind { kDay, kTurntable, kFilm };
std::string name_of(Kind kind);  // "day", "turntable", "film"

// "day-0001" for index 0.
std::string frame_name(const std::string& sequence, int index);
// Every tenth frame: their exposures represent all.
std::vector<std::size_t> every_tenth(std::size_t count);

}  // namespace cydonia
