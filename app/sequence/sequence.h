#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/reader/scene.h"
#include "render/options.h"

namespace cydonia {

// One picture of a sequence.
struct SequenceFrame {
    render::CameraOptions camera;  // its name is the frame's
    std::string when = {};         // for the frame's metadata: "17:42 (UTC+2)"
    // The moments of its shutter, in whose mean it moves; none: all at once.
    std::vector<render::CameraOptions> moments = {};
    // Where the camera is a frame later, for motion vectors; none: where it is.
    std::optional<render::CameraOptions> next = {};
    // The scene at this frame, where that varies in time; null: the job's.
    std::shared_ptr<const config::SceneSpec> scene = {};
};

// Pictures in a row, and the video of them.
struct Sequence {
    std::string name;    // "day": of the video, and of the frames "day-0001"
    std::string camera;  // whose view all frames are
    std::vector<SequenceFrame> frames;
    // All frames get one exposure: the middle of what these would get by themselves.
    std::vector<std::size_t> exposed_by;
    double exposure = 0.0;  // EV, added to it
    double rate = 24.0;     // frames a second
    int still = 0;          // the frame on which the video stands still, from 0
    double hold = 0.0;      // seconds
};

// What a sequence is of: the sun goes round, the camera goes round, or the scene's own
// keys and paths play.
enum class Kind { kDay, kTurntable, kFilm };
std::string name_of(Kind kind);  // "day", "turntable", "film"

// "day-0001" for the first, 0.
std::string frame_name(const std::string& sequence, int index);
// Every tenth of so many: their exposures stand for all.
std::vector<std::size_t> every_tenth(std::size_t count);

}  // namespace cydonia
