#pragma once

#include <filesystem>

#include "synth/genetic/options.h"

namespace cydonia::config {

// A terrain library, as TOML (or .ttl, thesis.h):
//
//     levels = [90.0]
//     [[type]]
//     name = "plateau"
//     examples = ["~/dems/plateau-*.tif"]
//     example = [{ source = "package:jacksboro", window = [0.0, 0.4, 0.5, 1.0] }]
//
// Throws one bad_request that lists every mistake as file:line:column: message.
genetic::LibraryOptions load_library(const std::filesystem::path& file);

// Gives colours to the types that have none.
void colour_types(genetic::LibraryOptions& library);

}  // namespace cydonia::config
