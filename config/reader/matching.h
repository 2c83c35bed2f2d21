#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "config/reader/mistakes.h"

namespace cydonia::config {

// Replaces "~" in "~/dems/a.tif" by the user's home folder, as a shell does, and leaves
// other names unchanged.
std::string at_home(const std::string& name);

// Whether a name is a pattern: * stands for any letters, ? for one.
bool is_pattern(std::string_view name);

// The files that match a pattern such as "dems/*.tif" relative to `folder`, sorted.
// Throws Wrong when there are none or more than `most`.
std::vector<std::string> matching(const std::filesystem::path& folder,
                                  const std::string& pattern, std::size_t most);

}  // namespace cydonia::config
