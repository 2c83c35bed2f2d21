#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "field/source.h"

namespace cydonia {

// Real elevation models that Debian packages bring, by the names that scenes give them.
std::vector<std::string> packaged_dems();

// A description that ships with the program, for read_dem; its hash and size are those of
// the package's file too. Throws bad_request: the package is missing, and which it is.
Source open_packaged_dem(const std::string& name);

// Whether a file is such a description: it makes GDAL open another one.
bool is_packaged_dem(const std::filesystem::path& path);

}  // namespace cydonia
