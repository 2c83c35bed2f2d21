#pragma once

#include "field/camera.h"
#include "field/terrain.h"
#include "render/options.h"

namespace cydonia::render {

// A third, two thirds or all of the frame's size. Water counts as ground.
Camera place(const CameraOptions& options, const Terrain& terrain, Quality quality);

// Overhead and oblique, for scenes that name none.
std::vector<CameraOptions> default_cameras();

}  // namespace cydonia::render
