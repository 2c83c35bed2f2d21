#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace cydonia {

// A file that a scene names, checked at the door and opened when needed.
struct Source {
    std::filesystem::path path;  // absolute
    std::uint64_t hash = 0;      // xxHash (XXH3, 64 bits) of its bytes
    std::uint64_t size = 0;      // bytes

    std::string name() const { return path.filename().string(); }
};

// Hashes the file. Throws bad_request when it is missing, a folder, empty, unreadable or
// larger than 4 GiB; the message names the path only, callers prefix where it was asked
// for.
Source open_source(const std::filesystem::path& path);

}  // namespace cydonia
