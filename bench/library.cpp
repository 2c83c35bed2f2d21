// What analysing a terrain library takes (docs/terrain-library.md): twenty models of 1024
// x 1024 samples at 10 m, at all levels.

#include <fmt/core.h>

#include <vector>

#include "bench/measure.h"
#include "field/noise.h"
#include "synth/genetic/analysis.h"

using namespace cydonia;
using namespace cydonia::genetic;

int main() {
    constexpr int kModels = 20, kSide = 1024;
    std::vector<Terrain> models;
    for (int i = 0; i < kModels; ++i) {
        NoiseOptions noise;
        noise.octaves = 8;
        noise.h = 0.9;
        Terrain& model = models.emplace_back();
        model.spacing = 10.0;
        model.heights = noise_field(noise, kSide, kSide, 400.0, std::uint64_t(i));
    }
    const bench::Stopwatch watch;
    std::size_t edges = 0;
    for (const Terrain& model : models)
        for (const double level : {90.0, 30.0, 10.0})
            edges +=
                analysis_of(at_level(model, level))[std::size_t(Quantity::kEdgeScale)]
                    .count;
    fmt::print("{} models of {} x {} at 90, 30 and 10 m: {:.1f} s ({} edges)\n", kModels,
               kSide, kSide, watch.seconds(), edges);
}
