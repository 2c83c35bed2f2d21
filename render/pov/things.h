#pragma once

#include <string>

#include "field/terrain.h"
#include "render/scene/shot.h"

namespace cydonia::render::pov {

// What `<shot>.things.inc` says: the originals, and their copies that the shot's camera
// sees. Empty where the scene has no things.
std::string things(const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render::pov
