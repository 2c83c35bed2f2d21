// Rusnell 2009, section 4.6: features from the edges of a texture at 512 x 512, and of
// the texture laid three times three at 1536 x 1536; what a feature's search covers and
// what all takes. Prints one line a terrain and the ratio of the two mean areas.
//
//     build/bench/bench/search_area [--plot FOLDER]
//
// With --plot also draws every feature's area (figures 4.33 and 4.34, c and d).

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string_view>

#include "bench/measure.h"
#include "bench/plot.h"
#include "field/image.h"
#include "field/noise.h"
#include "field/parallel.h"
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
    // So long that a pass covers what it covers in the thesis, 35,463 and 38,650 cells.
    alpine.reach = metres(1850.0);
    options.mean_edge_weight = 1.0;
    options.edge_weight_deviation = 0.75;
    options.grain = metres(40.0);
    options.sea_level_scale = 1.01;
    options.sea_level_threshold = metres(5.0);
    options.blending_bias = 4.0;
    return options;
}

struct Result {
    int side = 0, features = 0;
    double layout_seconds = 0.0;       // graph, generators, profiles
    double approximate_seconds = 0.0;  // the pass with all of them
    double blend_seconds = 0.0;        // the passes of each
    double mean_area = 0.0;            // cells settled, a feature
    std::vector<int> areas;            // of each feature, where asked for

    double seconds() const {
        return layout_seconds + approximate_seconds + blend_seconds;
    }
};

std::vector<int> areas_of(const Ground& ground, const Halting& halting,
                          const std::vector<float>& approximate) {
    tbb::enumerable_thread_specific<LeastCost> paths(std::cref(ground.graph));
    std::vector<int> areas(static_cast<std::size_t>(ground.features.count()));
    parallel_for(ground.features.count(), [&](int f) {
        const Pass pass = pass_of(f, ground, halting, approximate, paths.local());
        areas[f] = static_cast<int>(pass.nodes.size());
    });
    return areas;
}

Result result_of(const Field<std::uint8_t>& grey, const fs::path& folder, bool areas) {
    const fs::path picture = folder / "texture.png";
    write_png(picture, grey);
    const Terrain flat{Field<float>(grey.width(), grey.height()), kSpacing, {}, {}, {}};
    const Options options = options_for(picture, flat.width());
    SilentProgress silent;
    Result result;
    result.side = grey.width();

    const bench::Stopwatch of_layout;
    const Layout layout = layout_of(options, flat, 1);
    const Ground ground = layout.ground();
    result.layout_seconds = of_layout.seconds();
    result.features = layout.features.count();

    const bench::Stopwatch of_approximate;
    const std::vector<float> approximate = approximate_heights(ground, layout.halting);
    result.approximate_seconds = of_approximate.seconds();

    const bench::Stopwatch of_blend;
    PassCounts counts;
    const Field<float> land =
        blended_heights(ground, layout.halting, {options.blending_bias, {}}, approximate,
                        silent, {}, &counts);
    result.blend_seconds = of_blend.seconds();
    result.mean_area = static_cast<double>(counts.features) / result.features;
    if (areas) result.areas = areas_of(ground, layout.halting, approximate);
    return result;
}

void print(const char* name, const Result& result) {
    fmt::print(
        "{:7} {:4} x {:4} {:6} {:12.0f} {:8.2f} {:12.2f} {:8.2f} {:8.2f} {:8.1f}\n", name,
        result.side, result.side, result.features, result.mean_area,
        result.layout_seconds, result.approximate_seconds, result.blend_seconds,
        result.seconds(),
        result.mean_area * result.features / result.blend_seconds / 1e6);
    std::fflush(stdout);
}

// Figures 4.33 and 4.34, c and d: both with the same scale upwards.
void plot(const char* name, const Result& one, const Result& nine, const fs::path& to) {
    const double most = 1.05 * *std::ranges::max_element(nine.areas);
    std::vector<bench::Plot> plots;
    for (const Result* result : {&one, &nine}) {
        bench::Plot& plot = plots.emplace_back();
        plot.title = fmt::format("Search area, {0} x {0}", result->side);
        plot.x = {"feature", 0.0, 1.0 * result->features};
        plot.y = {"cells", 0.0, most};
        plot.points = {{"", "#1f6f8b", {}, result == &one ? 1.5 : 0.6}};
        for (int f = 0; f < result->features; ++f) {
            plot.points[0].at.push_back({1.0 * f, 1.0 * result->areas[f]});
        }
    }
    bench::write_plots(to, fmt::format("search-area-{}", name), plots);
}

void run(const Test& test, const fs::path& folder, const fs::path& plots) {
    const Field<std::uint8_t> tile = texture(test.cells);
    const Result one = result_of(tile, folder, !plots.empty());
    print(test.name, one);
    const Result nine = result_of(tiled(tile, 3), folder, !plots.empty());
    print(test.name, nine);
    fmt::print(
        "{:7} mean areas {:.2f} to 1 (thesis: 0.83 and 0.82), times 1 to {:.2f} "
        "(12.61 and 11.83)\n",
        test.name, one.mean_area / nine.mean_area, nine.seconds() / one.seconds());
    if (!plots.empty()) plot(test.name, one, nine, plots);
}

}  // namespace
}  // namespace cydonia::distance

int main(int argc, char** argv) try {
    using namespace cydonia;
    if (argc != 1 && !(argc == 3 && std::string_view(argv[1]) == "--plot")) {
        fmt::print(stderr, "search_area [--plot FOLDER]\n");
        return 2;
    }
    const bench::ScratchFolder scratch;
    fmt::print("{:7} {:>11} {:>6} {:>12} {:>8} {:>12} {:>8} {:>8} {:>8}\n", "test", "",
               "count", "cells each", "layout", "approximate", "blend", "all s", "M/s");
    for (const auto& test :
         {distance::Test{"first", 30.6}, distance::Test{"second", 25.7}}) {
        distance::run(test, scratch.path(), argc == 3 ? argv[2] : "");
    }
} catch (const cydonia::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
