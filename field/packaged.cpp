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
    const char* file;  // as config/exemplars/NAME.vrt names it
};

constexpr Packaged kPackaged[] = {
    {"jacksboro", "python-matplotlib-data",
     "/usr/share/matplotlib/mpl-data/sample_data/jacksboro_fault_dem.npz"},
    {"topography", "qtdatavisualization5-examples",
     "/usr/lib/x86_64-linux-gnu/qt5/examples/datavisualization/texturesurface/"
     "topography.png"},
};

fs::path description_of(const std::string& name) {
    return data_file(fmt::format("exemplars/{}.vrt", name));
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
    std::error_code ignored;
    if (!fs::exists(packaged->file, ignored))
        throw bad_request(
            "the package {} is not installed (no file '{}'); sudo apt install {}",
            packaged->package, packaged->file, packaged->package);
    const Source data = open_source(packaged->file);
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
