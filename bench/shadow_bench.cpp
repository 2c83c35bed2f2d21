#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>

#include "render/shadow/caster.h"
#include "tests/render/shadow_land.h"

namespace cydonia::render {
namespace {

// The process' peak so far: run one size at a time (--benchmark_filter) to read it.
double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

Field<float> mountains(int side) { return fractal(side, side, 6.0f, 1); }

void build_caster(benchmark::State& state) {
    const Field<float> heights = mountains(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(Caster(heights, 1.0));
    state.counters["peak_MB"] = peak_megabytes();
}

void cast_shadow(benchmark::State& state) {
    const Field<float> heights = mountains(static_cast<int>(state.range(0)));
    const int rays = static_cast<int>(state.range(1));
    const Caster caster(heights, 1.0);
    const Sun sun = sun_at(55.0, 25.0);
    for (auto _ : state) benchmark::DoNotOptimize(caster.shadow(sun, rays));
    const Mask mask = caster.shadow(sun, 1);
    state.counters["dark"] =
        static_cast<double>(area(mask)) / static_cast<double>(mask.size());
    state.counters["rays_per_s"] =
        benchmark::Counter(static_cast<double>(heights.size()) * rays * rays,
                           benchmark::Counter::kIsIterationInvariantRate);
    state.counters["peak_MB"] = peak_megabytes();
}

BENCHMARK(build_caster)
    ->Arg(512)
    ->Arg(1024)
    ->Arg(4096)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(cast_shadow)
    ->Args({512, 1})
    ->Args({512, 2})
    ->Args({1024, 1})
    ->Args({1024, 2})
    ->Args({4096, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace cydonia::render

BENCHMARK_MAIN();
