// 4096 x 4096 samples, 10 m apart as 512 samples are over 5120 m, with 2,000 random
// features that have a profile: seconds and the most memory that the process had.
//
//     build/bench/bench/large [SAMPLES FEATURES]

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "bench/measure.h"
#include "synth/distance/blend.h"
#include "synth/distance/layout.h"

using namespace cydonia;
using namespace cydonia::distance;

namespace {

constexpr double kSpacing = 10.0;

// Lengths are in metres, for thesis units grow with the terrain's width.
Options options_for(int features, double width) {
    Options options;
    Group& group = options.groups.emplace_back();
    group.name = "mountains";
    group.where.emplace<Peaks>().placement.count = features;
    group.cost.noise.grid *= width / 5120.0;
    group.cost.noise.scale = metres(300.0);
    group.profile = {"alpine"};
    Profile& alpine = options.profiles.emplace_back();
    alpine.name = "alpine";
    alpine.curve.points = {{0, 1}, {5, 0.8}, {20, 0.5}, {60, 0.2}, {130, 0.05}, {200, 0}};
    alpine.reach = metres(2000.0);
    options.grain = metres(40.0);
    options.sea_level_threshold = metres(5.0);
    return options;
}

struct Made {
    Field<float> land;
    int features = 0;
    PassCounts counts;
};

// run() of synth/distance/distance.h, step by step.
Made made(const Options& options, int samples) {
    Made made;
    SilentProgress silent;
    const auto print = [](const char* step, const bench::Stopwatch& watch) {
        fmt::print("{:12} {:7.2f} s {:8.0f} MiB at most so far\n", step, watch.seconds(),
                   bench::peak_mebibytes());
    };
    const bench::Stopwatch of_layout;
    const Layout layout =
        layout_of(options, {Field<float>(samples, samples), kSpacing, {}, {}, {}}, 1);
    const Ground ground = layout.ground();
    print("layout", of_layout);

    const bench::Stopwatch of_approximate;
    const std::vector<float> approximate = approximate_heights(ground, layout.halting);
    print("approximate", of_approximate);

    const bench::Stopwatch of_blend;
    made.land = blended_heights(ground, layout.halting, {options.blending_bias, {}},
                                approximate, silent, {}, &made.counts);
    print("blend", of_blend);
    made.features = layout.features.count();
    return made;
}

int number(const char* text, int otherwise) {
    const std::string_view digits(text ? text : "");
    int value = otherwise;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

}  // namespace

int main(int argc, char** argv) try {
    const int samples = number(argc > 1 ? argv[1] : nullptr, 4096);
    const int features = number(argc > 2 ? argv[2] : nullptr, 2000);
    const bench::Stopwatch watch;
    const Made result = made(options_for(features, samples * kSpacing), samples);
    const double seconds = watch.seconds();
    const auto rising = std::ranges::count_if(result.land, [](float h) { return h > 0; });
    const auto nodes = static_cast<double>(result.counts.features);
    fmt::print(
        "{0} x {0}, {1} features, {2:.0f} % of the land above the sea\n", samples,
        result.features,
        100.0 * static_cast<double>(rising) / static_cast<double>(result.land.size()));
    fmt::print("{:.0f} M nodes settled in the features' passes, {:.0f} a feature\n",
               nodes / 1e6, nodes / result.features);
    fmt::print("{:.1f} s (asked: 60), {:.2f} GiB (asked: under 2)\n", seconds,
               bench::peak_mebibytes() / 1024.0);
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
