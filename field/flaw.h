#pragma once

#include <filesystem>
#include <string_view>

namespace cydonia {

// What is wrong with the bytes of a PNG or JPEG, empty when nothing is: cut short, or not
// what its checksums say. Their libraries take a cut file without a word (JPEG) or write
// to the terminal by themselves (PNG). Other formats' libraries find it: empty.
std::string_view flaw_of(const std::filesystem::path& path, std::string_view format);

}  // namespace cydonia
