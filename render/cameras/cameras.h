#pragma once

#include <optional>
#include <vector>

#include "field/camera.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// A third, two thirds or all of the frame's size. Water counts as ground, `flood`
// included. Throws bad_request, saying what to change, for a camera under the ground (a
// path: anywhere on it), one that has no land in its frame, and one focused behind
// itself.
Camera place(const CameraOptions& options, const Terrain& terrain, Quality quality,
             const std::optional<WaterOptions>& flood = {});

// Whether a turntable can carry the camera: it looks at the land from outside.
bool can_turn(const CameraOptions& options);

// Across the frame's width, radians.
double field_of_view(const CameraOptions& options);

// Overhead and oblique, for scenes that name none.
std::vector<CameraOptions> default_cameras();

}  // namespace cydonia::render
