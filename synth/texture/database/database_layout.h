#pragma once

#include <xxhash.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace cydonia::texture {

// The format of a database's file. The head is followed by the body, an archive
// (field/archive.h): for each exemplar its size and name; for each level its signs, the
// number of seeds of each type, and its arrays, each aligned.
struct Head {
    char magic[32];
    std::uint64_t key;       // database_key() of the options
    std::uint64_t checksum;  // of the head without it and the body
    std::uint64_t size;      // of the body, bytes
    double spacing, unit;    // as in Database
    float lowest, highest;
    std::uint32_t exemplars, levels, types, reserved[9];
};

// The number at the end is raised when the same options give another database.
inline constexpr char kMagic[32] = "cydonia exemplars 4";
inline constexpr std::size_t kAligned = 64;
static_assert(sizeof(Head) % kAligned == 0);

// The body is hashed in pieces, so that several threads can take part; then the pieces'
// hashes and the head are.
inline constexpr std::size_t kPiece = std::size_t{1} << 20;
inline std::uint64_t checksum_of(Head head, const std::vector<std::uint64_t>& pieces) {
    head.checksum = XXH3_64bits(pieces.data(), pieces.size() * sizeof(std::uint64_t));
    return XXH3_64bits(&head, sizeof head);
}

}  // namespace cydonia::texture
