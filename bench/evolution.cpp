// What a height field of the "thirds" map takes, level by level (Saunders 2006, table
// VI.1), and how good it is.
//
//     evolution LIBRARY FOLDER [SAMPLES SPACING [SEED]]

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <string>

#include "bench/measure.h"
#include "config/reader/library.h"
#include "field/dem.h"
#include "field/image.h"
#include "synth/genetic/height_field.h"

using namespace cydonia;
using namespace cydonia::genetic;

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const std::string folder = argv[2];
    const int n = argc > 3 ? std::atoi(argv[3]) : 326;
    const double spacing = argc > 4 ? std::atof(argv[4]) : 30.0;
    const std::uint64_t seed = argc > 5 ? std::strtoull(argv[5], nullptr, 10) : 1;
    const LibraryOptions library = config::load_library(argv[1]);
    SilentProgress progress;
    bench::Stopwatch reading;
    constexpr int kLevels = 5, kRatio = 3;
    const std::vector<std::uint8_t> used(library.types.size(), 1);
    auto samples = samples_of(library, used, spacing, kRatio, kLevels, progress);
    fmt::print("samples read: {:.2f} s\n", reading.seconds());

    Regions regions;
    regions.at = Field<int>(n, n);
    regions.types = {0, 1, 2}, regions.cells = {0, 0, 0};
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double a = std::atan2(y - 0.5 * n, x - 0.5 * n) + 0.5;
            const int r = int(std::floor((a + 6.2831853) / 2.0943951)) % 3;
            regions.at(x, y) = r, ++regions.cells[std::size_t(r)];
        }
    const int base = base_level(samples, regions, n, n, kRatio, 810.0);
    samples.erase(samples.begin(), samples.begin() + base);
    EvolutionOptions options;
    if (const char* p = std::getenv("POPULATION")) options.population = std::atoi(p);
    if (const char* p = std::getenv("CYCLES")) options.cycles = std::atoi(p);
    if (const char* p = std::getenv("OVERLAP")) options.overlap = std::atof(p);
    std::unique_ptr<ByTexture> texture;
    double from = 0.0, to = 0.0;
    if (std::getenv("FROM")) {
        from = std::atof(std::getenv("FROM")), to = std::atof(std::getenv("TO"));
        bench::Stopwatch making;
        texture = std::make_unique<ByTexture>(library, used, to, folder, progress);
        fmt::print("database: {:.2f} s\n", making.seconds());
    }
    bench::Stopwatch watch;
    const auto done = height_field(regions, samples, kRatio, options, {}, texture.get(),
                                   from, to, seed, progress);
    fmt::print("all levels: {:.2f} s\n", watch.seconds());
    for (const LevelDone& level : done) {
        fmt::print("{:6.0f} m  {} x {}  {} genes of {}  seam {:.2f}\n", level.spacing,
                   level.heights.width(), level.heights.height(), level.genes, level.side,
                   level.seam_energy);
        if (!level.generations.empty())
            for (const auto& g : {level.generations.front(), level.generations.back()})
                fmt::print(
                    "     fitness {:.4f} compatibility {:.4f} similarity {:.4f} mean "
                    "{:.4f}\n",
                    g.fitness, g.compatibility, g.similarity, g.mean_fitness);
        Terrain terrain;
        terrain.spacing = level.spacing, terrain.heights = level.heights;
        write_geotiff(fmt::format("{}/{:.0f}.tif", folder, level.spacing), terrain);
    }
}
