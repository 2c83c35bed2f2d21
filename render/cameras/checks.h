#pragma once

#include "field/camera.h"
#include "field/terrain.h"
#include "render/cameras/options.h"
#include "render/cameras/path.h"

// What a camera may not do. Each throws bad_request, naming the camera and what to
// change.
namespace cydonia::render {

// The keys of a path: at least two, frames rising.
void check_keys(const CameraOptions& options);
// That a path is over the ground, and looks somewhere, in every whole frame.
void check_path(const CameraOptions& options, const TimedCurve& eye,
                const TimedCurve& target, const Terrain& surface);
// That eye and target are apart.
void check_axis(const Camera& camera, const CameraOptions& options,
                const Terrain& surface);
// That the eye is over the ground and over the water, which `surface` has and `land` not.
void check_eye(const Camera& camera, const CameraOptions& options, const Terrain& surface,
               const Terrain& land);
// That there is land in the frame.
void check_view(const Camera& camera, const CameraOptions& options,
                const Terrain& surface);
// That what is to be sharp is ahead.
void check_focus(const Camera& camera, const CameraOptions& options);

}  // namespace cydonia::render
