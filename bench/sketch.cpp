// What a sketch stage takes (docs/sketching.md): 512 x 512 samples, 6 levels, a landform
// and a region as large as the terrain.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/measure.h"
#include "field/noise.h"
#include "synth/sketch/landform.h"
#include "synth/sketch/region.h"

using namespace cydonia;
using namespace cydonia::sketch;

namespace {

constexpr int kSide = 512, kLevels = 6;
constexpr double kSpacing = 10.0;

template <class Work>
double milliseconds(const Work& work) {
    double least = HUGE_VAL;
    for (int i = 0; i < 9; ++i) {
        const bench::Stopwatch watch;
        work();
        least = std::min(least, watch.seconds());
    }
    return 1e3 * least;
}

}  // namespace

int main() {
    NoiseOptions options;
    options.octaves = 7;
    options.h = 1.0;
    const Field<float> land = noise_field(options, kSide, kSide, 60.0, 3);
    const double side = kSide * kSpacing;
    Landform landform{texture::shape_through({{0.1 * side, 0.45 * side},
                                              {0.5 * side, 0.55 * side},
                                              {0.9 * side, 0.5 * side}},
                                             "ridge"),
                      Field<float>(410, 1), [&](double) {
                          return std::array{side, side};
                      }};
    for (int i = 0; i < 410; ++i)
        landform.silhouette[std::size_t(i)] = float(
            500.0 * std::sin(M_PI * i / 409.0) + 40.0 * gradient_noise(i / 20.0, 0.5, 1));
    const texture::Shape loop = texture::shape_through(
        {{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}, {0.0, 0.0}}, "loop");
    const NoiseLevels noise = noise_of(landform.silhouette, kLevels, false);
    fmt::print("landform over all of {0} x {0}, {1} levels: {2:.1f} ms\n", kSide, kLevels,
               milliseconds([&] {
                   Field<float> made = land;
                   deform(made, kSpacing, landform, kLevels, 1);
               }));
    fmt::print("region over all of it: {:.1f} ms\n", milliseconds([&] {
                   Field<float> made = land;
                   roughen(made, kSpacing, loop, noise, kLevels, 1);
               }));
}
