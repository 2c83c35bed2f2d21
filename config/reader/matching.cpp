#include "config/reader/matching.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace cydonia::config {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostEntries = 65536;  // of a folder that is looked through

// Only * and ? are special: [ and \ are ordinary letters of names.
std::string escaped(const std::string& pattern) {
    std::string text;
    for (const char c : pattern) {
        if (c == '[' || c == '\\') text += '\\';
        text += c;
    }
    return text;
}

// Names of the regular files of a folder, in no order.
std::vector<std::string> files_in(const fs::path& folder) {
    std::error_code error;
    std::vector<std::string> names;
    std::size_t entries = 0;
    for (fs::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
        if (++entries > kMostEntries)
            throw Wrong{fmt::format("the folder '{}' holds more than {} files",
                                    folder.string(), kMostEntries)};
        std::error_code ignored;
        if (at->is_regular_file(ignored)) names.push_back(at->path().filename().string());
    }
    if (error)
        throw Wrong{fmt::format("cannot look into the folder '{}': {}", folder.string(),
                                error.message())};
    return names;
}

}  // namespace

std::string at_home(const std::string& name) {
    const char* home = std::getenv("HOME");
    if (!name.starts_with("~/") || !home || !*home) return name;
    return std::string(home).append(name, 1);
}

bool is_pattern(std::string_view name) { return name.find_first_of("*?") != name.npos; }

std::vector<std::string> matching(const fs::path& folder, const std::string& pattern,
                                  std::size_t most) {
    const fs::path path = at_home(pattern), parent = path.parent_path();
    const std::string name = path.filename().string(), wanted = escaped(name);
    if (is_pattern(parent.string()))
        throw Wrong{fmt::format(
            "'{}': * and ? may stand in a file's name only, not in a folder's", pattern)};
    std::vector<std::string> found = files_in(folder / parent);
    std::erase_if(found, [&](const std::string& file) {
        return fnmatch(wanted.c_str(), file.c_str(), FNM_PERIOD) != 0;
    });
    if (found.empty())
        throw Wrong{fmt::format("no file matches '{}' (looked in {})", name,
                                (folder / parent).lexically_normal().string())};
    if (found.size() > most)
        throw Wrong{fmt::format("{} files match '{}'; at most {} can be used",
                                found.size(), pattern, most)};
    std::ranges::sort(found);
    for (std::string& file : found) file = (parent / file).string();
    return found;
}

}  // namespace cydonia::config
