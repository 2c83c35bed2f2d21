#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "field/quantise.h"
#include "field/terrain.h"
#include "render/scene/land_maps.h"
#include "render/scene/shot.h"
#include "render/scene/water.h"

namespace cydonia::render {

// The .pov as text, commented, to run with plain `povray` in the folder of its assets.
// Pure. `added`: files that what the caller appends to it needs.
std::string pov_scene(const Shot& shot, const Heights16& heights, double spacing,
                      const std::optional<WaterSurface>& water = {},
                      const std::vector<std::string>& added = {});

// Writes what all shots share (heights, water, ground, sky visibility) and, per shot, its
// sky, <name>.pov and <name>.ini into `folder`, flat, as POV-Ray's file security wants
// it. Gives the names of the files.
std::vector<std::string> write_pov_assets(const std::filesystem::path& folder,
                                          const Terrain& terrain, const LandMaps& maps);
std::vector<std::string> write_pov_scene(const std::filesystem::path& folder,
                                         const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render
