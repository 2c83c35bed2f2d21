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

// The text of a .pov, with comments, to be run with plain `povray` in the folder of its
// assets. `added` names further files that text appended by the caller needs.
std::string pov_scene(const Shot& shot, const Heights16& heights, double spacing,
                      const std::optional<WaterSurface>& water = {},
                      const std::vector<std::string>& added = {});

// Write the files of a .pov into `folder` and return their names: write_pov_assets()
// those that all shots share (heights, water, ground, sky visibility), write_pov_scene()
// those of one shot (render/scene/files.h).
std::vector<std::string> write_pov_assets(const std::filesystem::path& folder,
                                          const Terrain& terrain, const LandMaps& maps);
std::vector<std::string> write_pov_scene(const std::filesystem::path& folder,
                                         const Shot& shot, const Terrain& terrain);

}  // namespace cydonia::render
