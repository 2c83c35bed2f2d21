#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace cydonia {

// A file that a scene names. It is checked when the scene is read and opened when it is
// needed.
struct Source {
    std::filesystem::path path;  // absolute
    std::uint64_t hash = 0;      // xxHash (XXH3, 64 bits) of its bytes
    std::uint64_t size = 0;      // bytes

    std::string name() const { return path.filename().string(); }
};

// Hashes the file. Throws bad_request when it is missing, a folder, empty, unreadable or
// larger than 4 GiB. The message names the path only; callers put before it where the
// path stands.
Source open_source(const std::filesystem::path& path);

}  // namespace cydonia
