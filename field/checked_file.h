#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace cydonia {

// Files of ours that only we read: a line that names kind and version, a checksum, a
// body. Written atomically (field/files.h).
void write_checked(const std::filesystem::path& file, std::string_view kind,
                   std::string_view body);
// The body; nothing when the file is missing, of another kind, cut short or damaged.
std::optional<std::string> read_checked(const std::filesystem::path& file,
                                        std::string_view kind);

}  // namespace cydonia
