// For r_cost.sh, which see: writes a random cost raster and 64 starts, then finds the
// least costs from them as GRASS r.cost defines them (a step costs the mean of its two
// cells, times sqrt 2 where it is diagonal) and compares them with what GRASS found.
//
//     r_cost write FOLDER             costs.bin, starts.txt
//     r_cost compare FOLDER SECONDS   with grass.bin, which took GRASS that long

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measure.h"
#include "field/files.h"
#include "field/random.h"
#include "synth/distance/cost_model.h"

using namespace cydonia;
using namespace cydonia::distance;
namespace fs = std::filesystem;

namespace {

constexpr int kSide = 2048;
constexpr int kStarts = 64;

template <class T>
void write_raster(const fs::path& path, const Field<T>& field) {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(field.data()),
              static_cast<std::streamsize>(field.size() * sizeof(T)));
    if (!out.flush()) throw failure("cannot write {}", path.string());
}

template <class T>
Field<T> raster(const fs::path& path) {
    Field<T> field(kSide, kSide);
    std::ifstream in(path, std::ios::binary);
    in.read(reinterpret_cast<char*>(field.data()),
            static_cast<std::streamsize>(field.size() * sizeof(T)));
    if (!in) throw failure("{} is not there or too short", path.string());
    return field;
}

struct Cell {
    int x, y;
};

std::vector<Cell> start_cells() {
    const auto place = [](std::uint64_t axis, std::uint64_t i) {
        return static_cast<int>(unit(hash_of({axis, i})) * kSide);
    };
    std::vector<Cell> cells;
    for (std::uint64_t i = 0; i < kStarts; ++i)
        cells.push_back({place(1, i), place(2, i)});
    return cells;
}

// Costs from 1 to 10; starts as "east,north,east,north,...", cells being 1 wide.
void write_inputs(const fs::path& folder) {
    Field<float> costs(kSide, kSide);
    for (std::size_t i = 0; i < costs.size(); ++i) {
        costs[i] = static_cast<float>(1.0 + 9.0 * unit(hash_of({3, i})));
    }
    write_raster(folder / "costs.bin", costs);
    std::string starts;
    for (const auto& [x, y] : start_cells()) {
        starts +=
            fmt::format("{}{},{}", starts.empty() ? "" : ",", x + 0.5, kSide - y - 0.5);
    }
    write_text(folder / "starts.txt", starts + "\n");
}

Graph graph_over(const Field<float>& costs) {
    EdgeOptions plain;
    plain.mean = 1.0;
    plain.deviation = 0.0;
    Graph graph = graph_of(kSide, kSide, 1.0, plain, 0);
    const int half = graph.directions / 2;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            for (int d = 0; d < half; ++d) {
                const int x1 = x + graph.offset[d].x, y1 = y + graph.offset[d].y;
                if (!costs.contains(x1, y1)) continue;
                const float length =
                    x1 != x && y1 != y ? std::numbers::sqrt2_v<float> : 1;
                graph.weights[static_cast<std::size_t>(graph.node(x, y)) * half + d] =
                    0.5f * length * (costs(x, y) + costs(x1, y1));
            }
        }
    }
    return graph;
}

struct Found {
    Field<float> least{kSide, kSide};
    double pass_seconds = 0.0;  // the pass alone
    double all_seconds = 0.0;   // from a file of costs to one of least costs
};

Found least_costs(const fs::path& folder) {
    Found found;
    const bench::Stopwatch all;
    const Graph graph = graph_over(raster<float>(folder / "costs.bin"));
    std::vector<Start> starts;
    for (const auto& [x, y] : start_cells()) starts.push_back({graph.node(x, y), 0.0f});
    const bench::Stopwatch pass;
    LeastCost paths(graph);
    paths.spread(starts, RawCostModel{starts});
    found.pass_seconds = pass.seconds();
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) found.least(x, y) = paths[graph.node(x, y)].cost;
    write_raster(folder / "ours.bin", found.least);
    found.all_seconds = all.seconds();
    return found;
}

double largest_difference(const Field<float>& ours, const Field<double>& theirs) {
    double largest = 0.0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const double difference = std::abs(ours[i] - theirs[i]);
        largest = std::max(largest, difference / std::max(1.0, theirs[i]));
        if (std::isnan(difference)) return difference;
    }
    return largest;
}

int compare(const fs::path& folder, double grass_seconds) {
    const Found found = least_costs(folder);
    const double difference =
        largest_difference(found.least, raster<double>(folder / "grass.bin"));
    const auto ratio = [&](double seconds) { return grass_seconds / seconds; };
    fmt::print("{0} x {0}, {1} starts, one thread\n", kSide, kStarts);
    fmt::print("GRASS r.cost                      {:7.2f} s\n", grass_seconds);
    fmt::print("our pass                          {:7.2f} s   1 to {:.1f} (asked: 10)\n",
               found.pass_seconds, ratio(found.pass_seconds));
    fmt::print("with reading, graph and writing   {:7.2f} s   1 to {:.1f}\n",
               found.all_seconds, ratio(found.all_seconds));
    fmt::print("largest relative difference       {:7.1e}\n", difference);
    return difference < 1e-4 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string_view mode = argc > 1 ? argv[1] : "";
    if (mode == "write" && argc == 3) {
        write_inputs(argv[2]);
        return 0;
    }
    if (mode == "compare" && argc == 4) return compare(argv[2], std::stod(argv[3]));
    fmt::print(stderr, "r_cost write FOLDER | r_cost compare FOLDER SECONDS\n");
    return 2;
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
