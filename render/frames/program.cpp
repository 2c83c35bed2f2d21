#include "render/frames/program.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace cydonia::render {
namespace fs = std::filesystem;
namespace {

bool is_program(const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

std::optional<fs::path> program_on_path(std::string_view name) {
    const char* variable = std::getenv("PATH");
    const std::string_view folders = variable ? variable : "";
    for (std::size_t begin = 0; begin < folders.size();) {
        const auto end = std::min(folders.find(':', begin), folders.size());
        const fs::path program = fs::path(folders.substr(begin, end - begin)) / name;
        if (end > begin && is_program(program)) return fs::absolute(program);
        begin = end + 1;
    }
    return std::nullopt;
}

}  // namespace cydonia::render
