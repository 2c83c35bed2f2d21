#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "app/pipeline/key.h"
#include "field/terrain.h"

namespace cydonia {

// The terrains between stages, with their masks and shadow images, in one archive for
// each key (field/archive.h). Only this version of the program, on this machine, reads
// them.
std::filesystem::path cached_terrain(const std::filesystem::path& folder, Key key);
void store_terrain(const std::filesystem::path& file, const Terrain& terrain);
// None if the file is missing, of another version, cut short or damaged.
std::optional<Terrain> load_terrain(const std::filesystem::path& file);

// Removes the terrains used longest ago until the rest take at most `max_bytes`. The one
// used last stays, and so do the files `kept`, however large they are.
void prune_terrains(const std::filesystem::path& folder, std::uint64_t max_bytes,
                    std::span<const std::filesystem::path> kept = {});

}  // namespace cydonia
