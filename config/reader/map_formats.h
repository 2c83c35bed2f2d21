#pragma once

#include <filesystem>
#include <string>

#include "field/areas.h"
#include "synth/genetic/options.h"

// The formats that map.cpp chooses from, beside those of thesis.h.
namespace cydonia::config {

inline constexpr std::size_t kMostMapBytes = 16u << 20, kMostMapRegions = 4096,
                             kMostMapCorners = 1'000'000;

genetic::MapOptions map_from_toml(const std::filesystem::path& file);
genetic::MapOptions map_from_ogr(const std::filesystem::path& file, VectorFormat format);
genetic::MapOptions map_from_svg(const std::filesystem::path& file,
                                 const genetic::LibraryOptions& library);

// The name of a region whose file gives none, such as "mountains 3".
std::string name_of_region(const genetic::MapOptions& map, const std::string& type);

}  // namespace cydonia::config
