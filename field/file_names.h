#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cydonia {

// A text as a file name without an extension, at most 64 bytes long. Small letters,
// digits, '_' and '-' stay as they are. Any other text keeps what is readable of it (its
// letters of any script; signs become '-'), '~' and a hash, so that no two texts have the
// same name, on disks that do not tell capitals from small letters either.
std::string file_name_of(std::string_view text);

// The same for texts that stand side by side. One of ASCII alone goes without the hash,
// so that "sea floor" is "sea-floor", unless another of them would have that name too.
std::vector<std::string> file_names_of(const std::vector<std::string>& texts);

}  // namespace cydonia
