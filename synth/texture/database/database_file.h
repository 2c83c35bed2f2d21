#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "field/progress.h"
#include "synth/texture/database/database.h"

namespace cydonia::texture {

// Hash of all that a database depends on: files' bytes and options.
std::uint64_t database_key(const Options& options);

// The file of that key in a folder.
std::filesystem::path database_file(const std::filesystem::path& folder,
                                    std::uint64_t key);

// A database that is mapped from its file, checked to the last byte. Null when there is
// none, or another, a damaged or an older one.
std::shared_ptr<const Database> mapped_database(const std::filesystem::path& file,
                                                std::uint64_t key);

// Throws a failure() when it cannot be written.
void write_database(const std::filesystem::path& file, std::uint64_t key,
                    const Database& database, Progress& progress);

// Removes the databases used longest ago until the folder's are within `most` bytes,
// never the one used last.
void prune_databases(const std::filesystem::path& folder, std::uint64_t most);

}  // namespace cydonia::texture
