#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "field/source.h"

namespace cydonia {

// The names by which scenes call the real elevation models that Debian packages contain.
std::vector<std::string> packaged_dems();

// Opens the description of such a model, which ships with the program, for read_dem().
// Its hash and size include the package's file. Throws bad_request that names the package
// when it is not installed.
Source open_packaged_dem(const std::string& name);

// Whether a file is such a description, which makes GDAL open another file.
bool is_packaged_dem(const std::filesystem::path& path);

}  // namespace cydonia
