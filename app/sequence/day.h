#pragma once

#include <string>
#include <vector>

#include "app/sequence/sequence.h"
#include "config/reader/scene.h"
#include "field/terrain.h"

namespace cydonia {

// A day over the land: the sun from low in the east to low in the west.
struct Day {
    Sequence sequence;
    // What the user should read: when each image appears, or why not and what to change.
    std::vector<std::string> messages;
    bool appears = true;  // the first image, while the sun is up
};

// The sun of [frames]'s place and date, or without one the arc through the sun of the
// first of `images`; `camera` films.
Day day_over(const config::FramesSpec& frames, const render::CameraOptions& camera,
             const std::vector<ShadowImage>& images);

// Throws bad_request where there is no day to film: neither an image nor a place, or a
// polar night.
void check_day(const config::SceneSpec& scene);

// The one that films: [frames]'s, else the first that looks straight down, else the
// first.
const render::CameraOptions& filming_camera(
    const config::FramesSpec& frames, const std::vector<render::CameraOptions>& cameras);

}  // namespace cydonia
