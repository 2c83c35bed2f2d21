#pragma once

#include <string>
#include <vector>

#include "app/sequence/sequence.h"
#include "config/reader/scene.h"
#include "field/terrain.h"

namespace cydonia {

// A day: the sun moves from low in the east to low in the west.
struct Day {
    Sequence sequence;
    // For the user: when each image appears, or why it does not and what to change.
    std::vector<std::string> messages;
    bool appears = true;  // whether the first image does
};

// The day at the place and date of [frames], or without them the arc of the sun through
// the sun of the first image. `camera` films it.
Day day_over(const config::FramesSpec& frames, const render::CameraOptions& camera,
             const std::vector<ShadowImage>& images);

// Throws bad_request if there is no day to film: no image and no place, or a polar night.
void check_day(const config::SceneSpec& scene);

// The camera that films: that of [frames], else the first that looks straight down, else
// the first.
const render::CameraOptions& filming_camera(
    const config::FramesSpec& frames, const std::vector<render::CameraOptions>& cameras);

}  // namespace cydonia
