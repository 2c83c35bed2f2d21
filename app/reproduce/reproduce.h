#pragma once

#include <filesystem>
#include <optional>

#include "app/console.h"

namespace cydonia {

// Makes everything of a manifest again, in `output` or else in a temporary folder that is
// removed when nothing differs, and prints how each file compares. Throws bad_request for
// a manifest that cannot be followed, and an Error of ExitCode::kCheckFellShort when a
// file differs.
void reproduce(const std::filesystem::path& manifest,
               const std::optional<std::filesystem::path>& output, Console& console);

}  // namespace cydonia
