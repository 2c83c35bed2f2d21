#pragma once

#include <string>
#include <vector>

#include "field/terrain.h"
#include "render/pov/scene.h"
#include "render/things/placement.h"

namespace cydonia::render::pov {

// The copies of each kind that a shot's frame is drawn with.
std::vector<std::vector<Thing>> things_of(const Shot& shot, const Terrain& terrain);

// What `things_<shot>.inc` says: the originals, and their copies that the shot's camera
// sees. Empty where the scene has no things.
std::string things(const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render::pov
