#pragma once

#include <optional>
#include <vector>

#include "field/camera.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// Places a camera over a terrain. The frame has a third (draft), two thirds (preview) or
// all (final) of its size in pixels. Water, including `flood`, counts as ground. Throws
// bad_request, saying what to change, when the camera is under the ground (on a path: at
// any frame), sees no land or is focused behind itself.
Camera place(const CameraOptions& options, const Terrain& terrain, Quality quality,
             const std::optional<WaterOptions>& flood = {});

// Whether a turntable can carry the camera, which must look at the land from outside.
bool can_turn(const CameraOptions& options);

// The field of view across the frame's width, radians.
double field_of_view(const CameraOptions& options);

// One overhead and one oblique camera, for scenes that name none.
std::vector<CameraOptions> default_cameras();

}  // namespace cydonia::render
