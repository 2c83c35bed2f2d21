#pragma once

#include <filesystem>

#include "synth/genetic/options.h"

// The two file formats of Saunders 2006. Both functions throw bad_request with the first
// mistake as file:line: message.
namespace cydonia::config {

// A terrain library (.ttl, figure V.5): sections with a type's samples, which are models
// in the file's folder by their names without an ending, and sections with the smoothness
// of seams. Aggregates, which are worked out anew, are passed over.
genetic::LibraryOptions load_thesis_library(const std::filesystem::path& file);

// A map (.map, figure V.10), after Wavefront's OBJ: corners 'v EAST NORTH', then terrain
// types 'tt TYPE', each with faces 'f 1 2 3' of corners.
genetic::MapOptions map_from_thesis(const std::filesystem::path& file);

}  // namespace cydonia::config
