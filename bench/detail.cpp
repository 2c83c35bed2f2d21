// What details by example take and what they restore (docs/detail.md):
//     detail --speed
//     detail EXEMPLAR [FOLDER]
// --speed: the sizes of Brosz 2007's trials, and 4096 x 4096 with the most memory held.
// EXEMPLAR: its west half is coarsened four times and given details of its east half, by
// every means, beside the truth. Spectrum: decibels over the truth's in the two
// octaves that were lost. Level: roughness that was added to the most level tenth, as a
// multiple of what is really there. The lands go into FOLDER.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bench/land_figures.h"
#include "bench/measure.h"
#include "bench/texture_transfer.h"
#include "field/dem.h"
#include "field/noise.h"
#include "field/sampled.h"
#include "synth/detail/detail.h"
#include "synth/detail/fractal.h"

using namespace cydonia;
using namespace cydonia::detail;
namespace fs = std::filesystem;

namespace {

Field<float> some_land(int width, int height, double relief) {
    NoiseOptions noise;
    noise.octaves = 7;
    noise.h = 1.0;
    return noise_field(noise, width, height, relief, 7);
}

Field<float> made(const Field<float>& coarse, const std::vector<Example>& examples,
                  const Options& options) {
    SilentProgress silent;
    const int factor = 1 << options.levels;
    return refined(coarse, {}, examples, std::vector{Layer{}}, options, {},
                   block_side(options, coarse.width() * factor, coarse.height() * factor),
                   1, silent);
}

Example example_of_land(const Field<float>& land, const Options& options) {
    return example_of(land, {}, options.filter, options.levels);
}

void time(const char* name, int width, int height, const std::vector<Field<float>>& real,
          const Options& options) {
    std::vector<Example> examples;
    for (const Field<float>& land : real)
        examples.push_back(example_of_land(land, options));
    const Field<float> coarse = some_land(width, height, 500.0);
    double least = HUGE_VAL;
    Field<float> land;
    for (int i = 0; i < 5; ++i) {
        const bench::Stopwatch watch;
        land = made(coarse, examples, options);
        least = std::min(least, watch.seconds());
    }
    fmt::print("{}: {} x {} to {} x {}, {} levels: {:.1f} ms\n", name, width, height,
               land.width(), land.height(), options.levels, 1e3 * least);
}

void speed() {
    Options three;
    Options two;
    two.levels = 2;
    time("trial 1", 20, 20, {some_land(400, 400, 300.0), some_land(400, 400, 900.0)},
         three);
    time("trial 2", 700, 100, {some_land(2000, 1000, 300.0)}, two);
    time("large", 1025, 1025, {some_land(2048, 2048, 300.0)}, two);

    // The whole stage, which takes the land apart first.
    Terrain terrain;
    terrain.spacing = 10.0;
    terrain.heights = some_land(4096, 4096, 900.0);
    const bench::ScratchFolder folder;
    Terrain target;
    target.spacing = 10.0;
    target.heights = some_land(1024, 1024, 900.0);
    write_geotiff(folder.path() / "target.tif", target);
    two.targets.push_back({open_source(folder.path() / "target.tif"), {}});
    SilentProgress silent;
    Context context;
    context.progress = &silent;
    const bench::Stopwatch watch;
    const Terrain result = run(two, terrain, context);
    fmt::print("stage: {0} x {0}, 2 levels: {1:.2f} s, {2:.2f} GiB at most\n",
               result.heights.width(), watch.seconds(), bench::peak_mebibytes() / 1024.0);
}

// Energy by octave of the wave length, from two cells on: 2 to 4, 4 to 8.
std::vector<double> spectrum(const Field<float>& land) {
    cv::Mat image(land.height(), land.width(), CV_32F);
    for (int y = 0; y < land.height(); ++y)
        for (int x = 0; x < land.width(); ++x) {
            const auto window = [](int at, int count) {
                return 0.5 - 0.5 * std::cos(2.0 * M_PI * (at + 0.5) / count);
            };
            image.at<float>(y, x) =
                float(land(x, y) * window(x, land.width()) * window(y, land.height()));
        }
    cv::Mat waves;
    cv::dft(image, waves, cv::DFT_COMPLEX_OUTPUT);
    std::vector<double> octaves(2);
    for (int y = 0; y < waves.rows; ++y)
        for (int x = 0; x < waves.cols; ++x) {
            const auto frequency = [](int at, int count) {
                return double(std::min(at, count - at)) / count;
            };
            const double f =
                std::hypot(frequency(x, waves.cols), frequency(y, waves.rows));
            if (!(f > 0.125 && f <= 0.5)) continue;
            const auto& wave = waves.at<cv::Vec2f>(y, x);
            octaves[f > 0.25 ? 0 : 1] +=
                double(wave[0]) * wave[0] + double(wave[1]) * wave[1];
        }
    return octaves;
}

// What subdivision alone does not give, of the finest level.
Field<float> roughness(const Field<float>& land) {
    std::vector<Level> levels = decomposed(land, Filter::kChaikin, 1);
    return subdivided(Field<float>(levels[0].coarse.width(), levels[0].coarse.height()),
                      levels[0].details, Filter::kChaikin);
}

// Root of the mean square over the level tenth of a land: of its 16 x 16 cells those of
// the least relief.
double roughness_of_level(const Field<float>& land, const Field<float>& truth) {
    constexpr int kSide = 16;
    struct Part {
        float relief;
        int x, y;
    };
    std::vector<Part> parts;
    for (int y = 0; y + kSide <= truth.height(); y += kSide)
        for (int x = 0; x + kSide <= truth.width(); x += kSide)
            parts.push_back(
                {float(bench::relief(part(truth, x, y, kSide, kSide))), x, y});
    std::ranges::sort(parts, {}, &Part::relief);
    parts.resize(std::max<std::size_t>(1, parts.size() / 10));
    const Field<float> rough = roughness(land);
    double squares = 0.0;
    for (const Part& part : parts)
        for (const float r : cydonia::part(rough, part.x, part.y, kSide, kSide))
            squares += double(r) * r;
    return std::sqrt(squares / (double(parts.size()) * kSide * kSide));
}

struct Table {
    const Field<float>& truth;
    double spacing;
    fs::path folder;  // empty: no land is kept
    std::vector<double> wanted = spectrum(truth);
    double rough = roughness_of_level(truth, truth);

    void put(const std::string& name, const Field<float>& land, double seconds) const {
        double squares = 0.0;
        for (std::size_t i = 0; i < land.size(); ++i)
            squares += double(land[i] - truth[i]) * (land[i] - truth[i]);
        const std::vector<double> octaves = spectrum(land);
        const auto decibels = [&](std::size_t i) {
            return 10.0 * std::log10(octaves[i] / wanted[i]);
        };
        fmt::print("| {} | {:.2f} | {:+.1f} | {:+.1f} | {:.2f} | {:.2f} |\n", name,
                   std::sqrt(squares / double(land.size())), decibels(1), decibels(0),
                   roughness_of_level(land, truth) / rough, seconds);
        if (folder.empty()) return;
        Terrain terrain;
        terrain.spacing = spacing;
        terrain.heights = land;
        write_geotiff(folder / (name + ".tif"), terrain);
    }
};

// The truth without its details, and with those of `other`.
void by_details(const std::string& name, const Table& table, const Field<float>& other,
                const Options& options) {
    const int width = table.truth.width(), height = table.truth.height();
    const auto whole =
        padded(table.truth, divisible(options.filter, width, options.levels),
               divisible(options.filter, height, options.levels));
    const auto coarse = decomposed(whole, options.filter, options.levels).back().coarse;
    std::vector<Example> examples{example_of_land(other, options)};
    if (options.kind == Kind::kMultifractal) take_scale(examples[0]);
    const bench::Stopwatch watch;
    const Field<float> land = made(coarse, examples, options);
    table.put(name, part(land, 0, 0, width, height), watch.seconds());
}

void restore(const fs::path& exemplar, const fs::path& folder) {
    const Terrain model = read_dem(open_source(exemplar));
    Options options;
    options.levels = 2;
    int width = model.heights.width() / 2, height = model.heights.height();
    while (divisible(options.filter, width, options.levels) != width) --width;
    while (divisible(options.filter, height, options.levels) != height) --height;
    const Field<float> truth = part(model.heights, 0, 0, width, height);
    const Field<float> other =
        part(model.heights, model.heights.width() - width, 0, width, height);
    const auto coarse = decomposed(truth, options.filter, options.levels).back().coarse;
    if (!folder.empty()) fs::create_directories(folder);
    fmt::print("{}: {} x {} of {:.4g} m from {} x {}, details of the other half\n\n",
               exemplar.stem().string(), width, height, model.spacing, coarse.width(),
               coarse.height());
    fmt::print(
        "| by | RMSE, m | 4 to 8, dB | 2 to 4, dB | level ground | seconds |\n"
        "|---|---|---|---|---|---|\n");
    const Table table{truth, model.spacing, folder};
    table.put("truth", truth, 0.0);
    const Field<float> smooth = made(coarse, {}, options);
    table.put("subdivision", smooth, 0.0);
    // The coarse sample i lies over fine ones 4 i - 2 and 4 i - 1, half between.
    table.put("bicubic", sampled(coarse, {0.75, 0.75, 0.25}, width, height), 0.0);
    {
        const bench::Stopwatch watch;
        const Field<float> land = bench::texture_transferred(smooth, other, 1);
        table.put("height quilting", land, watch.seconds());
    }
    const auto by = [&](const char* name, const auto& change) {
        Options changed = options;
        change(changed);
        by_details(name, table, other, changed);
    };
    by("fBm", [](Options& o) { o.kind = Kind::kFractal; });
    by("multi-fractal", [](Options& o) { o.kind = Kind::kMultifractal; });
    by("details, random", [](Options&) {});
    by("details, PatchMatch", [](Options& o) { o.search = Search::kPatchMatch; });
    by("details, exhaustive", [](Options& o) { o.search = Search::kExhaustive; });
    by("details, adapted", [](Options& o) { o.adapt = true; });
    by("details, block 1 to 8", [](Options& o) { o.block = 1.0 / 8.0; });
    by("details, block 1 to 30", [](Options& o) { o.block = 1.0 / 30.0; });
    by("details, Haar", [](Options& o) { o.filter = Filter::kHaar; });
    by("details, Faber", [](Options& o) { o.filter = Filter::kFaber; });
    by("details, cubic", [](Options& o) { o.filter = Filter::kCubic; });
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) {
        fmt::print(stderr, "usage: detail --speed | detail EXEMPLAR [FOLDER]\n");
        return 2;
    }
    if (std::string_view(argv[1]) == "--speed")
        speed();
    else
        restore(argv[1], argc > 2 ? argv[2] : "");
} catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
