#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace cydonia {

// Counter-based random numbers: a hash of what the number is for, never a shared stream,
// so that the order of evaluation and the number of threads do not matter.

// The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
constexpr std::uint64_t mix(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

// A number for a purpose or a name (FNV-1a).
constexpr std::uint64_t key(std::string_view text) {
    std::uint64_t h = 0xcbf29ce484222325ULL;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return h;
}

// hash_of({seed, stage, key("ridge start"), i})
constexpr std::uint64_t hash_of(std::initializer_list<std::uint64_t> parts) {
    std::uint64_t h = 0;
    for (std::uint64_t part : parts) h = mix(h ^ part);
    return h;
}

// Uniform in [0, 1).
constexpr double unit(std::uint64_t hash) {
    return static_cast<double>(hash >> 11) * 0x1.0p-53;
}
// Uniform in [-1, 1).
constexpr double signed_unit(std::uint64_t hash) { return 2.0 * unit(hash) - 1.0; }

}  // namespace cydonia
