// Rusnell 2009, section 6.2, iterative refinement: what moving one drawn stroke of a
// scene by 2 % of the width costs when the passes of the run before are remembered. For
// three strokes: the share of the nodes that are settled again, with and without those of
// the approximate pass, which is always done again; the time; and whether the land has
// the bytes of a fresh run.
//
//     build/bench/bench/one_stroke scenes/musgrave

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "config/reader/scene.h"
#include "field/files.h"
#include "synth/distance/blend.h"
#include "synth/distance/layout.h"

using namespace cydonia;
namespace fs = std::filesystem;

namespace {

struct Move {
    const char* drawing;
    int stroke;   // counted from 1
    double x, y;  // of the drawing's 512 units
};
constexpr double kFar = 0.02 * 512.0;
constexpr std::array<Move, 3> kMoves{{
    {"mountains.svg", 2, kFar, 0.0},
    {"ridges.svg", 9, -kFar, 0.0},
    {"ridges.svg", 30, 0.0, kFar},
}};

// A copy of the scene's folder whose drawing has one stroke elsewhere.
fs::path moved(const fs::path& scene, const Move& move, const fs::path& folder) {
    fs::copy(scene, folder);
    const fs::path drawing = folder / move.drawing;
    std::string text = read_text(drawing);
    std::size_t place = 0;
    for (int i = 0; i < move.stroke; ++i) {
        place = text.find("<path ", i == 0 ? 0 : place + 1);
        if (place == std::string::npos) {
            throw bad_request("{} has no stroke {}", drawing.string(), move.stroke);
        }
    }
    text.insert(place + std::strlen("<path "),
                fmt::format("transform=\"translate({} {})\" ", move.x, move.y));
    write_text(drawing, text);
    return folder;
}

struct Run {
    Field<float> land;
    distance::PassCounts counts;
    std::size_t approximate = 0;  // nodes of the approximate pass
    std::string passes;           // for the next run
    double seconds = 0.0;
};

// As a distance stage runs; with what is remembered, or without any memory.
Run run_of(const fs::path& scene, const std::string* remembered) {
    using namespace distance;
    const auto spec = config::Scene::load(scene / "scene.toml").at(0);
    const auto& options = std::get<Options>(spec.stages.at(0).options);
    const config::TerrainSpec& t = spec.terrain;
    const double spacing = std::max(t.width, t.depth) / t.samples;
    const Terrain flat{Field<float>(static_cast<int>(std::lround(t.width / spacing)),
                                    static_cast<int>(std::lround(t.depth / spacing))),
                       spacing,
                       {},
                       {},
                       {}};
    SilentProgress silent;
    Run run;
    const bench::Stopwatch watch;
    const Layout layout = layout_of(options, flat, spec.seed);
    const Ground ground = layout.ground();
    const std::vector<float> approximate = approximate_heights(ground, layout.halting);
    std::optional<PassMemory> memory;
    if (remembered) memory.emplace(ground, layout.halting, *remembered);
    run.land =
        blended_heights(ground, layout.halting, {options.blending_bias, {}}, approximate,
                        silent, {memory ? &*memory : nullptr, nullptr}, &run.counts);
    if (memory) run.passes = memory->taken_bytes();
    run.seconds = watch.seconds();
    run.approximate = static_cast<std::size_t>(
        std::ranges::count_if(approximate, [](float height) { return height > 0.0f; }));
    return run;
}

bool same_bytes(const Field<float>& a, const Field<float>& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

double percent(std::size_t part, std::size_t all) {
    return 100.0 * static_cast<double>(part) / static_cast<double>(all);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) {
        fmt::print(stderr, "one_stroke scenes/musgrave\n");
        return 2;
    }
    const std::string nothing;
    const Run before = run_of(argv[1], &nothing);
    fmt::print("{:.0f} k nodes, {:.2f} s\n",
               static_cast<double>(before.counts.features) / 1e3, before.seconds);
    fmt::print("{:24} {:>13} {:>17} {:>9} {:>9}\n", "stroke moved", "settled again",
               "with approximate", "seconds", "a fresh");
    bool same = true;
    for (const Move& move : kMoves) {
        const bench::ScratchFolder scratch;
        const fs::path scene = moved(argv[1], move, scratch.path() / "scene");
        const Run after = run_of(scene, &before.passes);
        const Run fresh = run_of(scene, nullptr);
        const std::size_t again = after.counts.features - after.counts.recalled;
        const bool equal = same_bytes(after.land, fresh.land);
        same = same && equal;
        fmt::print(
            "{:24} {:12.2f}% {:16.2f}% {:9.2f} {:9.2f}  {}\n",
            fmt::format("{} {}", move.drawing, move.stroke),
            percent(again, after.counts.features),
            percent(again + after.approximate, after.counts.features + after.approximate),
            after.seconds, fresh.seconds, equal ? "the same bytes" : "OTHER BYTES");
    }
    return same ? 0 : 1;
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
