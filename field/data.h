#pragma once

#include <filesystem>
#include <string_view>

namespace cydonia {

// A data file that ships with the program ("ocio/config.ocio"): looked for in
// $CYDONIA_DATA, then beside the program (install prefix), then in the source tree it was
// built from. Throws failure().
std::filesystem::path data_file(std::string_view relative);
// The same of a folder of them ("profiles").
std::filesystem::path data_folder(std::string_view relative);

}  // namespace cydonia
