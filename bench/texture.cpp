// Land made of one real elevation model at a time, without constraints (Gain, Merry and
// Marais 2015, section 4), and how it compares with its exemplar.
//
//     build/bench/bench/texture [--seeds 3] [--size 512] -o FOLDER EXEMPLAR...
//
// Columns: seconds of a synthesis of `size` x `size` cells and of 1024 x 1024, median of
// five with the database loaded; of one as large as the exemplar the share of the
// exemplar's 16x16 blocks used, the share of cells that continue one patch on all sides,
// the cells of the patches that half the land lies in or in larger ones, and of the
// largest, the share that shows a feature of 32 or of 64 cells that is shown elsewhere
// too, and how many cells away the nearest is (bench/repeats.h); of size x size cells
// slopes and heights against parts of the exemplar
// (bench/land_figures.h), pits per 1000 and relief beside the exemplar's, and the share
// of cells outside its heights.
//
// Into FOLDER: <exemplar>-<seed>.tif, its map of sources as .png, figures.csv, and the
// databases, which the next run loads.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/land_figures.h"
#include "bench/measure.h"
#include "bench/repeats.h"
#include "field/dem.h"
#include "field/files.h"
#include "field/image.h"
#include "field/random.h"
#include "synth/texture/database/database.h"
#include "synth/texture/synthesis/patches.h"
#include "synth/texture/synthesis/synthesis.h"

using namespace cydonia;
namespace fs = std::filesystem;

namespace {

constexpr int kLarge = 1024;
constexpr int kTimes = 5;

struct Request {
    int seeds = 3, size = 512;
    fs::path folder;
    std::vector<fs::path> exemplars;
};

int number(const char* text, int low, int high) {
    int value = 0;
    const auto [end, error] = std::from_chars(text, text + std::strlen(text), value);
    if (error != std::errc() || *end || value < low || value > high)
        throw bad_request("{}: not a number from {} to {}", text, low, high);
    return value;
}

std::optional<Request> request_of(int argc, char** argv) {
    Request request;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word[0] != '-') {
            request.exemplars.emplace_back(word);
            continue;
        }
        if (++i == argc) return {};
        if (word == "--seeds") {
            request.seeds = number(argv[i], 1, 1000);
        } else if (word == "--size") {
            request.size = number(argv[i], 64, 8192);
        } else if (word == "-o") {
            request.folder = argv[i];
        } else {
            return {};
        }
    }
    if (request.folder.empty() || request.exemplars.empty()) return {};
    return request;
}

// Everything that a run needs of an exemplar.
struct Subject {
    std::string name;
    Terrain model;
    std::shared_ptr<const texture::Database> database;
};

Subject subject_of(const fs::path& path, const fs::path& cache) {
    texture::Options options;
    options.exemplars.push_back({open_source(path), {}, {}});
    SilentProgress silent;
    const bench::Stopwatch made;
    texture::database_of(options, cache, silent);
    const double first = made.seconds();
    const bench::Stopwatch loaded;
    Subject subject{path.stem().string(), read_dem(options.exemplars[0].source), {}};
    const double read = loaded.seconds();
    subject.database = texture::database_of(options, cache, silent);
    fmt::print("{}: {} x {}, {} m, database {:.2f} s, again {:.3f} s\n", subject.name,
               subject.model.heights.width(), subject.model.heights.height(),
               subject.model.spacing, first, loaded.seconds() - read);
    return subject;
}

struct Land {
    Terrain terrain;
    Field<texture::Origin> places;
    double seconds = 0.0;
};

// Unconstrained, from the plane's cell (0, 0).
Land land_of(const texture::Database& database, int seed, int width, int height) {
    using namespace texture;
    SilentProgress silent;
    const Controls controls{.seed = hash_of({std::uint64_t(seed)})};
    const bench::Stopwatch watch;
    const Synthesis made =
        synthesised(database, controls, {},
                    Window{0, 0, 0, width, height}.grown(kReadOut), nullptr, silent);
    Land land{{heights_of(database, made), database.spacing, {}, {}, {}},
              part(made.origins, kReadOut, kReadOut, width, height),
              watch.seconds()};
    return land;
}

double median_seconds(const texture::Database& database, int size) {
    std::vector<double> seconds;
    for (int i = 0; i < kTimes; ++i)
        seconds.push_back(land_of(database, i, size, size).seconds);
    std::ranges::nth_element(seconds, seconds.begin() + kTimes / 2);
    return seconds[kTimes / 2];
}

double outside(const Field<float>& land, const texture::Database& database) {
    return static_cast<double>(std::ranges::count_if(
               land,
               [&](float height) {
                   return height < database.lowest || height > database.highest;
               })) /
           static_cast<double>(land.size());
}

constexpr const char* kHeader =
    "exemplar,seed,seconds,seconds_1024,used,coherent,typical_patch,largest_patch,"
    "repeated_32,repeated_64,nearest_64,slopes,heights,pits,exemplar_pits,relief,"
    "exemplar_relief,outside\n";

std::string measured(const Subject& subject, int seed, const Request& request,
                     double seconds, double seconds_large) {
    const texture::Database& database = *subject.database;
    const Field<float>& model = subject.model.heights;
    const Land land = land_of(database, seed, request.size, request.size);
    const Land equal = land_of(database, seed, model.width(), model.height());
    const auto patches = texture::patch_figures(database, equal.places);
    const auto small_again = bench::repeats(equal.places, 32);
    const auto large_again = bench::repeats(equal.places, 64);
    const auto alike = bench::likeness(land.terrain.heights, model, database.spacing, 1);
    const std::string stem = fmt::format("{}-{}", subject.name, seed);
    write_geotiff(request.folder / (stem + ".tif"), land.terrain);
    write_png(request.folder / (stem + ".png"),
              texture::source_map(database, land.places));
    return fmt::format(
        "{},{},{:.3f},{:.3f},{:.3f},{:.3f},{},{},{:.4f},{:.4f},{:.0f},{:.2f},{:.2f},{:."
        "3f},"
        "{:.3f},{:.0f},{:.0f},{:.5f}\n",
        subject.name, seed, seconds, seconds_large, patches.used, patches.coherent,
        patches.typical, patches.largest, small_again.share, large_again.share,
        large_again.nearest, alike.slopes, alike.heights,
        bench::pits_per_1000(land.terrain.heights), bench::pits_per_1000(model),
        bench::relief(land.terrain.heights), bench::relief(model),
        outside(land.terrain.heights, database));
}

void run(const Request& request) {
    const fs::path cache = request.folder / "databases";
    make_folder(cache);
    std::string table = kHeader;
    for (const fs::path& path : request.exemplars) {
        const Subject subject = subject_of(path, cache);
        const double seconds = median_seconds(*subject.database, request.size);
        const double large = median_seconds(*subject.database, kLarge);
        for (int seed = 1; seed <= request.seeds; ++seed) {
            const std::string line = measured(subject, seed, request, seconds, large);
            fmt::print("{}", line);
            std::fflush(stdout);
            table += line;
        }
    }
    write_text(request.folder / "figures.csv", table);
    fmt::print("{}", kHeader);
}

}  // namespace

int main(int argc, char** argv) try {
    const std::optional<Request> request = request_of(argc, argv);
    if (!request) {
        fmt::print(stderr, "texture [--seeds 3] [--size 512] -o FOLDER EXEMPLAR...\n");
        return 2;
    }
    run(*request);
    return 0;
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
