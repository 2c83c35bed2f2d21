// What the exemplar database of synth/texture costs: seconds to build and to load it, and
// bytes a cell. The exemplars are named on the command line; with --eight they are cut
// and repeated (mirrored at their edges) to eight of 1024x1024.
#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "field/dem.h"
#include "field/error.h"
#include "synth/texture/database/database.h"

namespace {

using namespace cydonia;
namespace fs = std::filesystem;

class Notes final : public Progress {
  public:
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view sentence) override { fmt::print("{}\n", sentence); }
    void warn(std::string_view sentence) override { fmt::print("{}\n", sentence); }
};

struct FreshFolder {
    FreshFolder() {
        std::string name = (fs::temp_directory_path() / "cydonia-XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~FreshFolder() { fs::remove_all(path); }
    fs::path path;
};

double seconds_now() {
    return std::chrono::duration<double>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

int mirrored(int at, int size) {
    at %= 2 * size;
    return at < size ? at : 2 * size - 1 - at;
}

Source as_1024(const Source& source, double spacing, const fs::path& file) {
    const Terrain model = read_dem(source);
    Terrain square;
    square.spacing = spacing;
    square.heights = Field<float>(1024, 1024);
    for (int y = 0; y < 1024; ++y)
        for (int x = 0; x < 1024; ++x)
            square.heights(x, y) = model.heights(mirrored(x, model.heights.width()),
                                                 mirrored(y, model.heights.height()));
    write_geotiff(file, square);
    return open_source(file);
}

void print_costs(const texture::Options& options, const fs::path& cache) {
    Notes notes;
    double start = seconds_now();
    const auto made = texture::database_of(options, cache, notes);
    const double build = seconds_now() - start;
    start = seconds_now();
    const auto loaded = texture::database_of(options, cache, notes);
    const double load = seconds_now() - start;
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(cache)) bytes += entry.file_size();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print(
        "{} exemplars, {} cells, {} levels, {} orientations\n"
        "build {:.2f} s, load {:.3f} s, {:.1f} bytes a cell, peak {} MiB\n",
        made->names.size(), made->cells(), made->levels.size(), options.orientations,
        build, load, double(bytes) / double(loaded->cells()), usage.ru_maxrss / 1024);
}

int run(const std::vector<std::string>& arguments) {
    texture::Options options;
    bool eight = false;
    std::vector<Source> sources;
    for (const std::string& argument : arguments) {
        if (argument == "--eight")
            eight = true;
        else if (argument.starts_with("--orientations="))
            options.orientations = std::atoi(argument.c_str() + 15);
        else
            sources.push_back(open_source(argument));
    }
    if (sources.empty()) throw bad_request("name elevation models");
    const FreshFolder folder;
    if (eight) {
        options.spacing = read_dem(sources.front()).spacing;
        for (std::size_t i = 0; i < 8; ++i)
            options.exemplars.push_back(
                {as_1024(sources[i % sources.size()], options.spacing,
                         folder.path / fmt::format("{}.tif", i)),
                 {},
                 {}});
    } else {
        for (const Source& source : sources)
            options.exemplars.push_back({source, {}, {}});
    }
    print_costs(options, folder.path / "cache");
    return 0;
}

}  // namespace

int main(int count, char** values) {
    try {
        return run({values + 1, values + count});
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.code());
    }
}
