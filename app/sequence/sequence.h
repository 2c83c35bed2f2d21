#pragma once

#include <string>
#include <vector>

#include "render/options.h"

namespace cydonia {

// One picture of a sequence.
struct Shot {
    render::CameraOptions camera;  // its name is the frame's, its sun is set
    std::string when;              // for the frame's metadata: "17:42 (UTC+2)"
};

// Pictures of one land in a row, and the video of them.
struct Sequence {
    std::string name;    // "day": of the video, and of the frames "day-0001"
    std::string camera;  // whose view all shots are
    std::vector<Shot> shots;
    int key_shot = 0;       // all are exposed by its light; the video stands still on it
    double exposure = 0.0;  // EV, added to what the key shot would get by itself
    double rate = 24.0;     // frames a second
    double hold = 0.0;      // seconds
};

// "day-0001" for the first, 0.
std::string frame_name(const std::string& sequence, int index);

}  // namespace cydonia
