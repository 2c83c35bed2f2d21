#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "synth/texture/synthesis/synthesis.h"

namespace cydonia::texture {

// A run that the next one can keep to (section 5.3): the result of each of its passes and
// what was asked of each cell.
struct Run {
    std::uint64_t database = 0;  // key of the database that the origins refer to
    std::vector<Field<std::uint64_t>> asked;  // for each level, of the passes' windows
    Recording passes;
};

// A run in a file (field/archive.h). load_run() gives nothing when the file is missing,
// damaged or of another version.
void store_run(const std::filesystem::path& file, const Run& run);
std::optional<Run> load_run(const std::filesystem::path& file);

}  // namespace cydonia::texture
