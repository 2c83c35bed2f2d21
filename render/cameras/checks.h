#pragma once

#include "field/camera.h"
#include "field/terrain.h"
#include "render/cameras/options.h"
#include "render/cameras/path.h"

// Checks of a camera. Each throws bad_request, naming the camera and what to change.
namespace cydonia::render {

// A path has at least two keys, in order of frames.
void check_keys(const CameraOptions& options);
// A path is above the ground, and its eye and target are apart, in every whole frame.
void check_path(const CameraOptions& options, const TimedCurve& eye,
                const TimedCurve& target, const Terrain& surface);
// The eye and the target are apart.
void check_axis(const Camera& camera, const CameraOptions& options,
                const Terrain& surface);
// The eye is above the ground (`land`) and above the water (`surface` includes it).
void check_eye(const Camera& camera, const CameraOptions& options, const Terrain& surface,
               const Terrain& land);
// There is land in the frame.
void check_view(const Camera& camera, const CameraOptions& options,
                const Terrain& surface);
// The focus is in front of the camera.
void check_focus(const Camera& camera, const CameraOptions& options);

}  // namespace cydonia::render
