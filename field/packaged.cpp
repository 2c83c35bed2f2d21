#include "field/packaged.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "field/data.h"
#include "field/error.h"

namespace cydonia {
namespace fs = std::filesystem;
namespace {

struct Packaged {
    const char* name;
    const char* package;
    const char* file;  // as config/exemplars/NAME.vrt names it: absolute, or beside it
};

constexpr Packaged kPackaged[] = {
    {"jacksboro", "python-matplotlib-data",
     "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"},
    {"topography", "qtdatavisualization5-examples", "topography.png"},
};

fs::path description_of(const std::string& name) {
    return data_file(fmt::format("exemplars/{}.vrt", name));
}

std::string missing(const Packaged& packaged, const fs::path& file) {
    if (fs::path(packaged.file).is_absolute())
        return fmt::format("there is no file '{}'; sudo apt install {}", file.string(),
                           packaged.package);
    return fmt::format(
        "there is no file '{}'; take it out of the package: apt download {}, then "
        "dpkg-deb -x",
        file.string(), packaged.package);
}

}  // namespace

std::vector<std::string> packaged_dems() {
    std::vector<std::string> names;
    for (const Packaged& packaged : kPackaged) names.emplace_back(packaged.name);
    return names;
}

Source open_packaged_dem(const std::string& name) {
    const auto* packaged = std::ranges::find(kPackaged, name, &Packaged::name);
    if (packaged == std::end(kPackaged))
        throw bad_request("no package brings an elevation model '{}'", name);
    const fs::path file = description_of(name).parent_path() / packaged->file;
    std::error_code ignored;
    if (!fs::exists(file, ignored))
        throw bad_request("package:{}: {}", name, missing(*packaged, file));
    const Source data = open_source(file);
    Source source = open_source(description_of(name));
    source.hash = std::rotl(source.hash, 1) ^ data.hash;
    source.size += data.size;
    return source;
}

bool is_packaged_dem(const fs::path& path) {
    const auto names = packaged_dems();
    const std::string name = path.stem().string();
    if (path.extension() != ".vrt" || std::ranges::find(names, name) == names.end())
        return false;
    return path == fs::absolute(description_of(name)).lexically_normal();
}

}  // namespace cydonia
