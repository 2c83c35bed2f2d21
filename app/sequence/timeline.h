#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/sequence/sequence.h"

namespace cydonia {

// The scene as its own clock goes: values with keys, a camera on its path.
struct Timeline {
    Sequence sequence;
    std::vector<std::string> messages;  // what the user should read
};

// The scene over time.
struct Clock {
    std::function<config::SceneSpec(double frame)> at;
    bool varies = false;    // whether any value has keys
    double last_key = 0.0;  // the frame of the last of them
};

// Films with [frames]'s camera, else the first on a path, else the first, one frame of
// the file for each from 0 on: as many as [frames] says, else up to the last key.
// `cameras` are those of `first`, the scene at frame 0. Throws bad_request where nothing
// moves.
Timeline timeline(const Clock& clock, const config::SceneSpec& first,
                  const std::vector<render::CameraOptions>& cameras);

}  // namespace cydonia
