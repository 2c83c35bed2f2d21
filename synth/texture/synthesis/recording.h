#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// A run to keep to (section 5.3): what its passes left and what it was asked for.
struct Run {
    std::uint64_t database = 0;               // whose places these are
    std::vector<Field<std::uint64_t>> asked;  // by level, windows as the passes'
    Recording passes;
};

// Written under a temporary name and checked when it is read: nothing when there is none,
// or one that is damaged or of another version.
void store_run(const std::filesystem::path& file, const Run& run);
std::optional<Run> load_run(const std::filesystem::path& file);

}  // namespace cydonia::texture
