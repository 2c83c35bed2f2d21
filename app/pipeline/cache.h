#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "app/pipeline/key.h"
#include "field/terrain.h"

namespace cydonia {

// Terrains between stages, whole (masks and shadow images too), one checked file a key.
// Not a format to exchange: it is in this machine's byte order and only this version
// reads it.
std::filesystem::path cached_terrain(const std::filesystem::path& folder, Key key);
void store_terrain(const std::filesystem::path& file, const Terrain& terrain);
// Nothing when the file is missing, of another version, cut short or damaged.
std::optional<Terrain> load_terrain(const std::filesystem::path& file);

// Removes the terrains used longest ago until those left take at most `max_bytes`. The
// last one used stays, and so do the files `kept`, whatever they take.
void prune_terrains(const std::filesystem::path& folder, std::uint64_t max_bytes,
                    std::span<const std::filesystem::path> kept = {});

}  // namespace cydonia
