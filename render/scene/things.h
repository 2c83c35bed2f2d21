#pragma once

#include <vector>

#include "field/terrain.h"
#include "render/scene/shot.h"
#include "render/things/placement.h"

namespace cydonia::render {

// The copies that a shot shows, a list for each kind of thing of its scene.
std::vector<std::vector<Thing>> things_of(const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render
