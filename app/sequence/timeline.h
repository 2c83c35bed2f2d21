#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/sequence/sequence.h"

namespace cydonia {

// The film of a scene: values with keys and cameras on paths move.
struct Timeline {
    Sequence sequence;
    std::vector<std::string> messages;  // for the user
};

// A scene over time.
struct Clock {
    std::function<config::SceneSpec(double frame)> at;
    bool varies = false;    // whether any value has keys
    double last_key = 0.0;  // the frame of the last of them
};

// Frames 0, 1, 2 ... of the scene: as many as [frames] says, else up to the last key. The
// camera is that of [frames], else the first on a path, else the first. `cameras` are
// those of `first`, the scene at frame 0. Throws bad_request if nothing moves.
Timeline timeline(const Clock& clock, const config::SceneSpec& first,
                  const std::vector<render::CameraOptions>& cameras);

}  // namespace cydonia
