#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace cydonia::render {

// The path of an executable program on the PATH, if there is one.
std::optional<std::filesystem::path> program_on_path(std::string_view name);

}  // namespace cydonia::render
