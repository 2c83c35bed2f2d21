// Rusnell 2009, table A.1: every scene of the thesis at 512 samples, synthesis only,
// without the cache; its features, the nodes settled in the passes of single features,
// the time of graph and generators and of all (the least of three runs), beside the
// thesis'. With a folder for pictures also figure 4.35 (time against features) and figure
// 6.1 (histogram of times).
//
//     build/bench/bench/thesis_times scenes [PICTURES]

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "bench/measure.h"
#include "bench/plot.h"
#include "config/reader/scene.h"
#include "synth/distance/blend.h"
#include "synth/distance/layout.h"

using namespace cydonia;
namespace fs = std::filesystem;

namespace {

struct Entry {
    const char* scene;
    int features;
    double seconds;
};

constexpr std::array<Entry, 26> kTableA1{{
    {"v-valley", 2, 7},
    {"u-valley", 2, 8},
    {"canyon", 7, 7},
    {"layers", 7, 13},
    {"tower-karst", 8, 7},
    {"hills", 6, 7},
    {"mountain-range", 100, 24},
    {"river-terrace", 3, 8},
    {"fault", 6, 10},
    {"crater", 100, 36},
    {"cinder-cone", 4, 7},
    {"lunar", 38, 18},
    {"musgrave", 402, 27},
    {"edge-detection", 288, 71},
    {"edge-weights", 7, 12},
    {"edge-detection-and-weights-1", 54, 63},
    {"edge-detection-and-weights-2", 229, 128},
    {"edge-detection-and-weights-3", 344, 135},
    {"edge-detection-and-weights-4", 229, 75},
    {"u-of-s", 22, 9},
    {"img-logo", 16, 10},
    {"lambda", 3, 9},
    {"sketch-1", 31, 12},
    {"sketch-2", 58, 9},
    {"sketch-3", 38, 11},
    {"sketch-4", 15, 7},
}};

struct Measured {
    int features = 0;
    std::size_t nodes = 0;        // settled, of all passes with one feature
    double seconds = 0.0;         // in all
    double layout_seconds = 0.0;  // of these, for graph and generators
};

// Seconds, the least of three: what else the machine does only adds to it.
template <class Work>
double seconds_of(const Work& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const bench::Stopwatch watch;
        work();
        least = std::min(least, watch.seconds());
    }
    return least;
}

void count(const distance::Options& options, const Terrain& terrain, std::uint64_t seed,
           Measured& measured) {
    using namespace distance;
    Layout layout;
    measured.layout_seconds +=
        seconds_of([&] { layout = layout_of(options, terrain, seed); });
    const Ground ground = layout.ground();
    SilentProgress silent;
    PassCounts counts;
    blended_heights(ground, layout.halting, {options.blending_bias, {}},
                    approximate_heights(ground, layout.halting), silent, {}, &counts);
    measured.features += layout.features.count();
    measured.nodes += counts.features;
}

Measured measured(const fs::path& scene) {
    const auto spec = config::Scene::load(scene, {"terrain.samples=512"}).at(0);
    const double spacing = std::max(spec.terrain.width, spec.terrain.depth) / 512;
    const auto samples = [&](double metres) {
        return static_cast<int>(std::lround(metres / spacing));
    };
    Terrain land{Field<float>(samples(spec.terrain.width), samples(spec.terrain.depth)),
                 spacing,
                 {},
                 {},
                 {}};
    SilentProgress silent;
    Context context;
    context.seed = spec.seed;
    context.progress = &silent;
    Measured measured;
    for (const config::StageSpec& stage : spec.stages) {
        Terrain next;
        measured.seconds += seconds_of([&] { next = run(stage.options, land, context); });
        if (const auto* options = std::get_if<distance::Options>(&stage.options)) {
            count(*options, land, context.seed, measured);
        }
        land = std::move(next);
    }
    return measured;
}

using Points = std::vector<std::array<double, 2>>;

bench::Plot time_against_features(const Points& ours, const Points& thesis) {
    bench::Plot plot;
    plot.title = "Synthesis time against number of features, 512 x 512";
    plot.x = {"features", 1.0, 1000.0, true};
    plot.y = {"seconds", 0.01, 200.0, true};
    plot.points = {{"Rusnell 2009, table A.1", "#b9854a", thesis},
                   {"Cydonia", "#1f6f8b", ours}};
    return plot;
}

double longest_of(const Points& times) {
    double longest = 0.0;
    for (const auto& [features, seconds] : times) longest = std::max(longest, seconds);
    return longest;
}

// 1, 2 or 5 times a power of ten, so that 7 to 17 bars hold all times.
double bar_width(double longest) {
    const double decade = std::pow(10.0, std::floor(std::log10(longest / 7.0)));
    for (const double step : {5.0, 2.0}) {
        if (longest / (step * decade) >= 7.0) return step * decade;
    }
    return decade;
}

bench::Plot histogram(const char* title, const char* colour, const Points& times) {
    const double longest = longest_of(times), width = bar_width(longest);
    std::vector<double> counts(static_cast<std::size_t>(longest / width) + 1);
    for (const auto& [features, seconds] : times) {
        ++counts[static_cast<std::size_t>(seconds / width)];
    }
    bench::Plot plot;
    plot.title = title;
    plot.x = {"seconds", 0.0, width * static_cast<double>(counts.size())};
    plot.y = {"terrains", 0.0, *std::ranges::max_element(counts) + 1.0};
    plot.bars.push_back({colour, width, {}});
    for (std::size_t i = 0; i < counts.size(); ++i) {
        plot.bars[0].at.push_back({static_cast<double>(i) * width, counts[i]});
    }
    return plot;
}

void write_pictures(const fs::path& folder, const Points& ours, const Points& thesis) {
    bench::write_plots(folder, "time-against-features",
                       {time_against_features(ours, thesis)});
    bench::write_plots(folder, "times",
                       {histogram("Synthesis times: Rusnell 2009", "#b9854a", thesis),
                        histogram("Synthesis times: Cydonia", "#1f6f8b", ours)});
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) {
        fmt::print(stderr, "thesis_times SCENES [PICTURES]\n");
        return 2;
    }
    fmt::print("{:29} {:>8} {:>7} {:>9} {:>8} {:>8} {:>7}\n", "scene", "features",
               "thesis", "nodes", "layout", "seconds", "thesis");
    Points ours, thesis;
    double layout_seconds = 0.0, seconds = 0.0, thesis_seconds = 0.0;
    for (const Entry& entry : kTableA1) {
        const fs::path scene = fs::path(argv[1]) / entry.scene / "scene.toml";
        if (!fs::exists(scene)) {
            fmt::print("{:29} is not there\n", entry.scene);
            continue;
        }
        const Measured own = measured(scene);
        fmt::print("{:29} {:8} {:7} {:8.2f}M {:8.3f} {:8.3f} {:7.0f}\n", entry.scene,
                   own.features, entry.features, static_cast<double>(own.nodes) / 1e6,
                   own.layout_seconds, own.seconds, entry.seconds);
        ours.push_back({1.0 * own.features, own.seconds});
        thesis.push_back({1.0 * entry.features, entry.seconds});
        layout_seconds += own.layout_seconds;
        seconds += own.seconds;
        thesis_seconds += entry.seconds;
    }
    fmt::print("{:29} {:35.2f} {:8.2f} {:7.0f}   1 to {:.0f}\n",
               fmt::format("all {}", ours.size()), layout_seconds, seconds,
               thesis_seconds, thesis_seconds / seconds);
    if (argc > 2 && !ours.empty()) write_pictures(argv[2], ours, thesis);
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
