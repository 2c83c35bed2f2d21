// What a sketch stage takes and how near it keeps to its strokes (docs/sketching.md).

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bench/measure.h"
#include "field/files.h"
#include "field/noise.h"
#include "synth/sketch/bands.h"
#include "synth/sketch/landform.h"
#include "synth/sketch/region.h"
#include "synth/sketch/sketch.h"

using namespace cydonia;
using namespace cydonia::sketch;

namespace {

constexpr int kSide = 512, kLevels = 6;
constexpr double kSpacing = 10.0, kWidth = kSide * kSpacing;

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

Field<float> hills() {
    NoiseOptions options;
    options.octaves = 7;
    options.h = 1.0;
    return noise_field(options, kSide, kSide, 60.0, 3);
}

// As rough as mountains: a height at a share of a stroke, metres.
double jagged(double share) {
    double height = 500.0 * std::sin(M_PI * share);
    for (int octave = 0; octave < 7; ++octave)
        height += 80.0 * std::sin(M_PI * share) * std::exp2(-octave) *
                  gradient_noise(share * 5.0 * std::exp2(octave), 0.5, 7);
    return height;
}

Landform landform_through(const std::vector<Point2>& points, double boundary) {
    const geometry::Shape shadow = geometry::shape_through(points, "ridge");
    const int values = int(shadow.length() / kSpacing) + 1;
    Landform landform{shadow,
                      Field<float>(values, 1),
                      [boundary](double) {
                          return std::array{boundary, boundary};
                      },
                      {},
                      {true, true}};
    for (int i = 0; i < values; ++i)
        landform.silhouette[std::size_t(i)] = float(jagged(double(i) / (values - 1)));
    landform.noise = noise_of(landform.silhouette, kLevels, false).fitted;
    return landform;
}

void speed() {
    const Field<float> land = hills();
    const Landform landform = landform_through(
        {{0.0, 0.45 * kWidth}, {0.5 * kWidth, 0.55 * kWidth}, {kWidth, 0.5 * kWidth}},
        kWidth);
    const geometry::Shape loop = geometry::shape_through(
        {{0.0, 0.0}, {kWidth, 0.0}, {kWidth, kWidth}, {0.0, kWidth}, {0.0, 0.0}}, "loop");
    const NoiseLevels noise = noise_of(landform.silhouette, kLevels, false);
    fmt::print(
        "landform over all of {0} x {0}, {1} levels: {2:.1f} ms\n", kSide, kLevels,
        milliseconds([&] {
            Field<float> made = land;
            deform(made, kSpacing, {&landform, 1}, kLevels, wavelets(made, kLevels, 1));
        }));
    fmt::print("region over all of it: {:.1f} ms\n", milliseconds([&] {
                   Field<float> made = land;
                   roughen(made, kSpacing, loop, noise, kLevels, 1);
               }));
}

// Of what the noise alone changes, where it is not also bent to the stroke; over seeds,
// for a land has few features as wide as the widest band.
void noise_by_band() {
    constexpr int kSeeds = 24;
    Landform rough = landform_through({{0.0, 0.5 * kWidth}, {kWidth, 0.5 * kWidth}},
                                      0.45 * kWidth),
             smooth = rough;
    std::ranges::fill(smooth.noise, 0.0);
    std::vector<double> squares(kLevels), weights(kLevels);
    for (int seed = 0; seed < kSeeds; ++seed) {
        Field<float> with(kSide, kSide), without(kSide, kSide);
        const Noise noise = wavelets(with, kLevels, std::uint64_t(seed));
        const auto feet = deform(with, kSpacing, {&rough, 1}, kLevels, noise);
        deform(without, kSpacing, {&smooth, 1}, kLevels, noise);
        for (std::size_t i = 0; i < with.size(); ++i) with[i] -= without[i];
        const auto scales = smoothed(with, kLevels);
        for (std::size_t band = 0; band < kLevels; ++band)
            for (const Foot& foot : feet[0]) {
                if (foot.distance < 64.0f || foot.noise < 0.2f) continue;
                const double d = scales[band + 1][foot.index] - scales[band][foot.index];
                squares[band] += d * d, weights[band] += foot.noise * foot.noise;
            }
    }
    for (std::size_t band = 0; band < kLevels; ++band) {
        const double sigma = std::sqrt(squares[band] / weights[band]);
        fmt::print("noise of band {}: {:.2f} m, the fit's {:.2f} m: {:+.1f} %\n",
                   band + 1, sigma, rough.noise[band],
                   100.0 * (sigma / rough.noise[band] - 1.0));
    }
}

struct Quiet final : Progress {
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view) override {}
    void warn(std::string_view) override {}
};

// A jagged stroke over a frame, seen 20 degrees from above.
void in_a_view() {
    namespace fs = std::filesystem;
    const fs::path file = fs::temp_directory_path() / "cydonia-bench-sketch.svg";
    std::string path;
    for (int i = 0; i <= 400; ++i)
        path += fmt::format("{}{} {}", i ? " L" : "M", 300.0 + 1.7 * i,
                            430.0 - 0.4 * jagged(i / 400.0));
    write_text(file,
               "<svg xmlns='http://www.w3.org/2000/svg' width='1280' height='720'>"
               "<metadata><camera xmlns='urn:cydonia' eye='2560 -4000 2600' "
               "target='2560 2560 200' field-of-view='40'/></metadata>"
               "<path d='" +
                   path + "' fill='none'/></svg>");
    Options options;
    Feature& range = options.features.emplace_back();
    range.name = "range";
    range.view = View{open_source(file), "", false, {}};
    Terrain terrain;
    terrain.heights = hills(), terrain.spacing = kSpacing;
    Quiet quiet;
    Context context;
    context.progress = &quiet;
    const Terrain made = run(options, terrain, context);
    const float high = *std::ranges::max_element(made.heights);
    for (const auto& [name, value] : made.figures)
        fmt::print("{}: {:.2f}\n", name, value);
    fmt::print("(it is {:.0f} m high)\n", high);
    fs::remove(file);
}

}  // namespace

int main() {
    speed();
    noise_by_band();
    in_a_view();
}
