// Least-cost distance terrain: nodes settled a second, time, peak memory, and how far the
// land at another resolution is from that at 512 samples.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "bench/measure.h"
#include "field/random.h"
#include "synth/distance/blend.h"
#include "synth/distance/cost_model.h"
#include "synth/distance/distance.h"
#include "synth/distance/layout.h"

namespace cydonia::distance {
namespace {

constexpr double kExtent = 5120.0;

Group peaks_and_ridges(int peaks, int ridges) {
    Group group;
    group.name = "mountains";
    group.where.emplace<Peaks>().placement.count = peaks;
    group.ridges.count = ridges;
    return group;
}

// Rusnell 2009, chapter 3: 25 peaks, 38 ridges; raw edge weights shape the land.
Options without_profile() {
    Options options;
    options.groups = {peaks_and_ridges(25, 38)};
    return options;
}

// The same with a concave profile.
Options running_example() {
    Options options = without_profile();
    Profile concave;
    concave.name = "concave";
    for (int i = 0; i <= 20; ++i) {
        const double x = i / 20.0;
        concave.curve.points.push_back({130.0 * x, (1.0 - x) * (1.0 - x)});
    }
    options.profiles = {concave};
    options.groups[0].profile = {concave.name};
    return options;
}

// Section 5.4: the base terrain of TEXT.
Options text_base() {
    Options options;
    options.groups = {peaks_and_ridges(1311, 200)};
    options.groups[0].cost.kind = CostRule::Kind::kRandom;
    options.mean_edge_weight = 1.0;
    options.edge_weight_deviation = 0.75;
    return options;
}

Terrain flat(int samples) {
    return {Field<float>(samples, samples), kExtent / samples, {}, {}, {}};
}

Graph graph_for(const Options& options, int samples) {
    return graph_of(samples, samples, kExtent / samples, edges_of(options, kExtent), 1);
}

Field<float> heights(const Options& options, int samples) {
    SilentProgress silent;
    Context context;
    context.seed = 1;
    context.progress = &silent;
    return run(options, flat(samples), context).heights;
}

void report_memory(benchmark::State& state) {
    state.counters["peak_MiB"] = bench::peak_mebibytes();
}

void report_nodes(benchmark::State& state, std::size_t nodes) {
    state.counters["nodes/s"] = benchmark::Counter(
        static_cast<double>(nodes) * static_cast<double>(state.iterations()),
        benchmark::Counter::kIsRate);
}

void BM_Graph(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            graph_for(running_example(), static_cast<int>(state.range(0))));
    }
}

// 64 starts of no cost over raw weights: what `r.cost` of GRASS does.
void BM_LeastCost(benchmark::State& state) {
    const auto samples = static_cast<int>(state.range(0));
    const Graph graph = graph_for(running_example(), samples);
    std::vector<Start> starts;
    for (std::uint64_t i = 0; i < 64; ++i) {
        starts.push_back({graph.node(static_cast<int>(unit(hash_of({1, i})) * samples),
                                     static_cast<int>(unit(hash_of({2, i})) * samples)),
                          0.0f});
    }
    LeastCost paths(graph);
    for (auto _ : state) paths.spread(starts, RawCostModel{starts});
    report_nodes(state, paths.settled().size());
    report_memory(state);
}

// Steps 5 to 7 of Algorithm 3: the pass with all features, then one for each.
void passes(benchmark::State& state, const Options& options) {
    const Layout layout = layout_of(options, flat(static_cast<int>(state.range(0))), 1);
    const Ground ground = layout.ground();
    SilentProgress silent;
    PassCounts counts;
    std::vector<float> approximate;
    for (auto _ : state) {
        approximate = approximate_heights(ground, layout.halting);
        benchmark::DoNotOptimize(blended_heights(ground, layout.halting,
                                                 {options.blending_bias, {}}, approximate,
                                                 silent, {}, &counts));
    }
    const auto above_sea = static_cast<std::size_t>(
        std::ranges::count_if(approximate, [](float height) { return height > 0.0f; }));
    report_nodes(state, above_sea + counts.features);
    state.counters["approximate"] = static_cast<double>(above_sea);
    state.counters["features"] = static_cast<double>(counts.features);
    report_memory(state);
}
void BM_PassesOfRunningExample(benchmark::State& state) {
    passes(state, running_example());
}
void BM_PassesOfTextBase(benchmark::State& state) { passes(state, text_base()); }

void BM_RunningExample(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            heights(running_example(), static_cast<int>(state.range(0))));
    }
    report_memory(state);
}
void BM_TextBase(benchmark::State& state) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(heights(text_base(), static_cast<int>(state.range(0))));
    }
    report_memory(state);
}

// Means over 64 x 64 blocks: the low-pass of the resolution rule.
Field<float> blocks(const Field<float>& land) {
    const int n = land.width() / 64;
    Field<float> means(64, 64);
    for (int y = 0; y < land.height(); ++y) {
        for (int x = 0; x < land.width(); ++x) {
            means(x / n, y / n) += land(x, y) / static_cast<float>(n * n);
        }
    }
    return means;
}

// RMS difference from the land at 512 samples, in percent of the relief.
void resolution(benchmark::State& state, const Options& options) {
    const Field<float> middle = blocks(heights(options, 512));
    double squares = 0.0;
    for (auto _ : state) {
        const Field<float> other =
            blocks(heights(options, static_cast<int>(state.range(0))));
        squares = 0.0;
        for (std::size_t i = 0; i < other.size(); ++i) {
            squares += std::pow(other[i] - middle[i], 2.0);
        }
    }
    const double relief = *std::max_element(middle.begin(), middle.end());
    state.counters["rms_%"] =
        100.0 * std::sqrt(squares / static_cast<double>(middle.size())) / relief;
}
void BM_ResolutionOfRunningExample(benchmark::State& state) {
    resolution(state, running_example());
}
void BM_ResolutionWithoutProfile(benchmark::State& state) {
    resolution(state, without_profile());
}
void BM_ResolutionOfTextBase(benchmark::State& state) { resolution(state, text_base()); }

constexpr auto kUnit = benchmark::kMillisecond;
BENCHMARK(BM_Graph)->Arg(512)->Arg(2048)->Unit(kUnit)->UseRealTime();
BENCHMARK(BM_LeastCost)->Arg(512)->Arg(1024)->Arg(2048)->Unit(kUnit)->UseRealTime();
BENCHMARK(BM_PassesOfRunningExample)->Arg(512)->Arg(1024)->Unit(kUnit)->UseRealTime();
BENCHMARK(BM_PassesOfTextBase)->Arg(512)->Arg(1024)->Unit(kUnit)->UseRealTime();
BENCHMARK(BM_RunningExample)->Arg(256)->Arg(512)->Arg(1024)->Unit(kUnit)->UseRealTime();
BENCHMARK(BM_TextBase)->Arg(512)->Unit(kUnit)->UseRealTime();
BENCHMARK(BM_ResolutionOfRunningExample)->Arg(256)->Arg(1024)->Iterations(1)->Unit(kUnit);
BENCHMARK(BM_ResolutionWithoutProfile)->Arg(256)->Arg(1024)->Iterations(1)->Unit(kUnit);
BENCHMARK(BM_ResolutionOfTextBase)->Arg(256)->Arg(1024)->Iterations(1)->Unit(kUnit);

}  // namespace
}  // namespace cydonia::distance

BENCHMARK_MAIN();
