#pragma once

#include <filesystem>
#include <string_view>

namespace cydonia {

// Finds a data file that ships with the program, such as "ocio/config.ocio". It is looked
// for in $CYDONIA_DATA, then beside the program (the install prefix), then in the source
// tree that the program was built from. Throws failure() when it is in none of them.
std::filesystem::path data_file(std::string_view relative);
// Finds a folder of such files, such as "profiles".
std::filesystem::path data_folder(std::string_view relative);

}  // namespace cydonia
