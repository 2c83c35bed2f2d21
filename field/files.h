#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace cydonia {

// Calls write(temporary path in the same folder, same extension), then renames it to
// `path`: nothing half-written ever has a final name. On any exception the temporary file
// is removed; a full disk or a read-only folder becomes a failure() naming `path`.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

void write_text(const std::filesystem::path& path, std::string_view text);
std::string read_text(const std::filesystem::path& path,
                      std::size_t max_bytes = 64u << 20);

// Makes a folder and its parents. Throws a failure() that says what is in the way.
void make_folder(const std::filesystem::path& path);

}  // namespace cydonia
