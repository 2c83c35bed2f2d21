#pragma once

#include <optional>
#include <vector>

#include "field/camera.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// The camera at a frame of a sequence; only a path differs from frame to frame. A third,
// two thirds or all of the frame's size. Water counts as ground, `flood` included. Throws
// bad_request, saying what to change, for a camera under the ground (a path: anywhere on
// it), one that has no land in its frame, and one focused behind itself.
Camera place(const CameraOptions& options, const Terrain& terrain, Quality quality,
             double frame = 0.0, const std::optional<WaterOptions>& flood = {});

// Across the frame's width, radians.
double field_of_view(const CameraOptions& options);

// Overhead and oblique, for scenes that name none.
std::vector<CameraOptions> default_cameras();

}  // namespace cydonia::render
