#pragma once

#include <string>

#include "field/terrain.h"
#include "render/scene/shot.h"

namespace cydonia::render::pov {

// The text of `<shot>.things.inc`: the originals, and the copies that the shot's camera
// sees. Empty when it sees none.
std::string things(const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render::pov
