#pragma once

#include <filesystem>
#include <string_view>

namespace cydonia {

// Says what is wrong with the bytes of a PNG or JPEG: that it is cut short, or that a
// checksum does not fit. Empty when nothing is wrong, and for other formats, whose
// libraries report damage themselves. The JPEG library accepts a cut file in silence, and
// the PNG library writes to the terminal.
std::string_view flaw_of(const std::filesystem::path& path, std::string_view format);

}  // namespace cydonia
