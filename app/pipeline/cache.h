#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "field/terrain.h"

namespace cydonia {

// What something was made from, as one number.
std::uint64_t hash_text(std::string_view text);
// Zero for a missing file, which no finished step was made from.
std::uint64_t hash_of_file(const std::filesystem::path& file);

// Terrains between stages, whole (masks and shadow images too), one checked file a key.
// Not a format to exchange: it is in this machine's byte order and only this version
// reads it.
std::filesystem::path cached_terrain(const std::filesystem::path& folder,
                                     std::uint64_t key);
void store_terrain(const std::filesystem::path& file, const Terrain& terrain);
// Nothing when the file is missing, of another version, cut short or damaged.
std::optional<Terrain> load_terrain(const std::filesystem::path& file);

// Removes the terrains used longest ago until those left, or the last one, take at most
// `max_bytes`.
void prune_terrains(const std::filesystem::path& folder, std::uint64_t max_bytes);

}  // namespace cydonia
