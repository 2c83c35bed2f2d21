#pragma once

#include <filesystem>

#include "synth/genetic/options.h"

namespace cydonia::config {

// A terrain library in the form of Saunders 2006, figure V.5: sections with a type's
// samples, which are models in the file's folder by their names without an ending. Seams
// and aggregates, which are worked out anew, are passed over. Throws one bad_request with
// the first mistake as file:line: message.
genetic::LibraryOptions load_ttl(const std::filesystem::path& file);

}  // namespace cydonia::config
