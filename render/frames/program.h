#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace cydonia::render {

// Where a program is on the PATH; none when it is nowhere or cannot be executed.
std::optional<std::filesystem::path> program_on_path(std::string_view name);

}  // namespace cydonia::render
