#pragma once

#include <filesystem>
#include <string_view>

namespace cydonia {

// Whether a PNG or JPEG goes on to its end mark. Their libraries take a file that was cut
// short without a word (JPEG) or write to the terminal by themselves (PNG); of every
// other format this says yes and leaves the finding to its library.
bool is_whole(const std::filesystem::path& path, std::string_view format);

}  // namespace cydonia
