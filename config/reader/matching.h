#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "config/reader/mistakes.h"

namespace cydonia::config {

// "~/dems/a.tif" below the user's home folder, as in a shell; other names as they are.
std::string at_home(const std::string& name);

// Whether a name stands for several: * for any letters, ? for one.
bool is_pattern(std::string_view name);

// The files that a pattern such as "dems/*.tif" stands for, seen from `folder`, sorted;
// at least one and at most `most`. Throws Wrong.
std::vector<std::string> matching(const std::filesystem::path& folder,
                                  const std::string& pattern, std::size_t most);

}  // namespace cydonia::config
