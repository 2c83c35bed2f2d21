// Rusnell 2009, section 4.6: features from the edges of a texture at 512 x 512, and of
// the texture laid three times three at 1536 x 1536; what a feature's search covers and
// what all takes. Prints one line a terrain and the ratio of the two mean areas.
//
//     build/bench/bench/search_area

#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <filesystem>

#include "field/image.h"
#include "field/noise.h"
#include "synth/distance/blend.h"
#include "synth/distance/layout.h"

namespace cydonia::distance {
namespace {

namespace fs = std::filesystem;

constexpr int kSide = 512;
constexpr double kSpacing = 10.0;

struct Test {
    const char* name;
    double cells;  // of noise across the texture: more make more features
};

// Noise whose edges are many short pieces; mirrored, so that it goes on across borders.
Field<std::uint8_t> texture(double cells) {
    Field<std::uint8_t> grey(kSide, kSide);
    const auto folded = [&](int i) {
        return (std::min(i, kSide - 1 - i) + 0.5) * cells / kSide;
    };
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double u = folded(x), v = folded(y);
            const double value =
                gradient_noise(u, v, 1) + 0.5 * gradient_noise(2 * u, 2 * v, 2);
            grey(x, y) = static_cast<std::uint8_t>(
                std::lround(std::clamp(0.5 + 0.5 * value, 0.0, 1.0) * 255.0));
        }
    }
    return grey;
}

Field<std::uint8_t> tiled(const Field<std::uint8_t>& tile, int times) {
    Field<std::uint8_t> grey(tile.width() * times, tile.height() * times);
    for (int y = 0; y < grey.height(); ++y)
        for (int x = 0; x < grey.width(); ++x)
            grey(x, y) = tile(x % tile.width(), y % tile.height());
    return grey;
}

// As the edge detection result, section 4.3.1, without its ridges.
Options options_for(const fs::path& picture, double width) {
    Options options;
    Group& edges = options.groups.emplace_back();
    edges.name = "edges";
    edges.where = Edges{open_source(picture)};
    edges.cost.noise.grid *= width / (kSide * kSpacing);
    edges.cost.noise.scale = metres(300.0);
    edges.profile = {"alpine"};
    Profile& alpine = options.profiles.emplace_back();
    alpine.name = "alpine";
    alpine.curve.points = {{0, 1}, {5, 0.8}, {20, 0.5}, {60, 0.2}, {130, 0.05}, {200, 0}};
    alpine.reach = metres(2000.0);
    options.mean_edge_weight = 1.0;
    options.edge_weight_deviation = 0.75;
    options.grain = metres(40.0);
    options.sea_level_scale = 1.01;
    options.sea_level_threshold = metres(5.0);
    options.blending_bias = 4.0;
    return options;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
        .count();
}

struct Result {
    int features = 0;
    double approximate_seconds = 0.0, seconds = 0.0, mean_area = 0.0;
};

Result result_of(const Field<std::uint8_t>& grey, const fs::path& folder) {
    const fs::path picture = folder / "texture.png";
    write_png(picture, grey);
    const Terrain flat{Field<float>(grey.width(), grey.height()), kSpacing, {}, {}, {}};
    const Options options = options_for(picture, flat.width());
    SilentProgress silent;

    const auto start = std::chrono::steady_clock::now();
    const Layout layout = layout_of(options, flat, 1);
    const Ground ground = layout.ground();
    const std::vector<float> approximate = approximate_heights(ground, layout.halting);
    Result result{layout.features.count(), seconds_since(start), 0.0, 0.0};
    PassCounts counts;
    const Field<float> land =
        blended_heights(ground, layout.halting, {options.blending_bias, {}}, approximate,
                        silent, {}, &counts);
    result.seconds = seconds_since(start);
    result.mean_area = static_cast<double>(counts.features) / result.features;
    return result;
}

void print(const char* name, int side, const Result& result) {
    fmt::print(
        "{:7} {:4} x {:4} {:6} features  {:8.0f} cells each  {:6.2f} s approximate  "
        "{:6.2f} s all  {:5.1f} M cells/s\n",
        name, side, side, result.features, result.mean_area, result.approximate_seconds,
        result.seconds, result.mean_area * result.features / result.seconds / 1e6);
}

void run(const Test& test, const fs::path& folder) {
    const Field<std::uint8_t> tile = texture(test.cells);
    const Result one = result_of(tile, folder);
    print(test.name, kSide, one);
    const Result nine = result_of(tiled(tile, 3), folder);
    print(test.name, 3 * kSide, nine);
    fmt::print(
        "{:7} mean areas {:.2f} to 1 (thesis: 0.83 and 0.82), times 1 to {:.2f} "
        "(12.61 and 11.83)\n",
        test.name, one.mean_area / nine.mean_area, nine.seconds / one.seconds);
}

}  // namespace
}  // namespace cydonia::distance

int main() {
    using namespace cydonia;
    const auto folder = std::filesystem::temp_directory_path() / "cydonia-search-area";
    std::filesystem::create_directories(folder);
    for (const auto& test :
         {distance::Test{"first", 48.0}, distance::Test{"second", 40.0}}) {
        distance::run(test, folder);
    }
    std::filesystem::remove_all(folder);
}
