#include "config/reader/elevation_models.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/reader/matching.h"
#include "field/error.h"
#include "field/packaged.h"

namespace cydonia::config {
namespace {

constexpr std::string_view kPackage = "package:";
constexpr std::string_view kGuide =
    "docs/your-own-mountains.md tells how to get elevation models";

Source packaged(const std::string& name) {
    const auto names = packaged_dems();
    if (std::ranges::find(names, name) == names.end())
        throw Wrong{
            fmt::format("no package '{}'{}", name, suggestion(name, packaged_dems()))};
    try {
        return open_packaged_dem(name);
    } catch (const Error& error) {
        throw Wrong{error.what()};
    }
}

// Runs a search for files, and adds the guide's name to its message when it finds none.
template <class Search>
auto guided(const Search& search) {
    try {
        return search();
    } catch (const Wrong& wrong) {
        throw Wrong{fmt::format("{}; {}", wrong.message, kGuide)};
    }
}

}  // namespace

Source ElevationModel::read(const Value& value, Files& files) const {
    const std::string name = Text{4096}.read(value, files);
    if (name.starts_with(kPackage)) return packaged(name.substr(kPackage.size()));
    if (is_pattern(name))
        throw Wrong{
            fmt::format("'{}' may be several files; name one, or use exemplars", name)};
    return guided([&] { return File{}.read(value, files); });
}

std::vector<Source> ElevationModels::read(const Value& value, Files& files) const {
    const std::string name = Text{4096}.read(value, files);
    if (name.starts_with(kPackage) || !is_pattern(name))
        return {ElevationModel{}.read(value, files)};
    return guided([&] {
        std::vector<Source> found;
        for (const std::string& file : files.matching(name, kMostModels))
            found.push_back(files.open(file));
        return found;
    });
}

}  // namespace cydonia::config
