#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "field/progress.h"
#include "synth/texture/database/database.h"

namespace cydonia::texture {

// A hash of everything that a database depends on: the files' bytes and the options.
std::uint64_t database_key(const Options& options);

// The path of the file with that key in a folder.
std::filesystem::path database_file(const std::filesystem::path& folder,
                                    std::uint64_t key);

// The database mapped from its file, all of whose bytes are checked. Null when the file
// is missing, damaged, of an older version or of another key.
std::shared_ptr<const Database> mapped_database(const std::filesystem::path& file,
                                                std::uint64_t key);

// Throws failure() when the file cannot be written.
void write_database(const std::filesystem::path& file, std::uint64_t key,
                    const Database& database, Progress& progress);

// Removes the least recently used databases until those in the folder have at most `most`
// bytes. The one used last always stays.
void prune_databases(const std::filesystem::path& folder, std::uint64_t most);

}  // namespace cydonia::texture
