#pragma once

#include <vector>

#include "field/terrain.h"
#include "render/scene/shot.h"
#include "render/things/placement.h"

namespace cydonia::render {

// The copies of each kind that a shot's frame is drawn with.
std::vector<std::vector<Thing>> things_of(const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render
