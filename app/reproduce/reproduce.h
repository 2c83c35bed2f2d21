#pragma once

#include <filesystem>
#include <optional>

#include "app/console.h"

namespace cydonia {

// Makes all files of a manifest again and prints how each compares with the first. They
// go to `output`, or else to a temporary folder that is removed if nothing differs.
// Throws bad_request for a manifest that cannot be followed, and an Error with
// ExitCode::kCheckFellShort if a file differs.
void reproduce(const std::filesystem::path& manifest,
               const std::optional<std::filesystem::path>& output, Console& console);

}  // namespace cydonia
