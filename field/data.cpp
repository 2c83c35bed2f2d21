#include "field/data.h"

#include <cstdlib>
#include <system_error>
#include <vector>

#include "field/error.h"

namespace cydonia {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> data_folders() {
    std::vector<fs::path> folders;
    if (const char* named = std::getenv("CYDONIA_DATA"); named && *named)
        folders.emplace_back(named);
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error)
        folders.push_back(program.parent_path().parent_path() / "share" / "cydonia");
    folders.emplace_back(CYDONIA_SOURCE_DATA);
    folders.push_back(folders.back().parent_path());  // where scenes/ stands
    return folders;
}

fs::path found(std::string_view relative, bool (*is_there)(const fs::path&)) {
    std::string looked_in;
    for (const fs::path& folder : data_folders()) {
        const fs::path path = folder / relative;
        if (is_there(path)) return path;
        looked_in += (looked_in.empty() ? "" : ", ") + folder.string();
    }
    throw failure(
        "the program's '{}' is missing (looked in {}); "
        "name its folder in the environment variable CYDONIA_DATA",
        relative, looked_in);
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

}  // namespace

fs::path data_file(std::string_view relative) { return found(relative, is_file); }
fs::path data_folder(std::string_view relative) { return found(relative, is_folder); }

}  // namespace cydonia
