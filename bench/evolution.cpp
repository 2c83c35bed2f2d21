// What a map of kinds of land takes, level by level (Saunders 2006, table VI.1), and how
// good it is, by both optimisers.
//
//     evolution LIBRARY MAP SAMPLES SPACING [FOLDER]
//
// Three seeds each. Into FOLDER go GeoTIFFs: every land (texture-1.tif), of each the
// largest square within each type (texture-1-hills.tif), and for each type its largest
// sample (hills.tif) and squares as large out of its others (hills-part-1.tif).

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "bench/land_figures.h"
#include "bench/measure.h"
#include "config/reader/library.h"
#include "config/reader/map.h"
#include "field/dem.h"
#include "field/random.h"
#include "synth/genetic/evolution/samples.h"
#include "synth/genetic/genetic.h"

using namespace cydonia;
using namespace cydonia::genetic;

namespace {

// How long each step took.
class StepTimes final : public Progress {
  public:
    void step(std::string_view name) override {
        finish();
        name_ = name, watch_ = {};
    }
    void finish() {
        if (!name_.empty()) steps_.emplace_back(name_, watch_.seconds());
        name_.clear();
    }
    void report(double) override {}
    void note(std::string_view) override {}
    void warn(std::string_view) override {}
    const auto& steps() const { return steps_; }

  private:
    std::string name_;
    bench::Stopwatch watch_;
    std::vector<std::pair<std::string, double>> steps_;
};

void write(const std::string& file, Field<float> heights, double spacing) {
    Terrain terrain;
    terrain.spacing = spacing, terrain.heights = std::move(heights);
    write_geotiff(file, terrain);
}

// The largest square within a type's mask: its north-west corner and side.
std::array<int, 3> largest_square(const Field<float>& mask) {
    Field<int> sides(mask.width(), mask.height());  // of the square that ends there
    std::array<int, 3> best{0, 0, 0};
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (mask(x, y) == 0.0f) continue;
            int& side = sides(x, y) = 1;
            if (x > 0 && y > 0)
                side += std::min({sides(x - 1, y), sides(x, y - 1), sides(x - 1, y - 1)});
            if (side > best[2]) best = {x - side + 1, y - side + 1, side};
        }
    return best;
}

void write_parts(const std::string& folder, const std::string& name, const Terrain& land,
                 const LevelSamples& samples, const LibraryOptions& library) {
    constexpr int kParts = 6;
    for (std::size_t t = 0; t < library.types.size(); ++t) {
        const std::string& type = library.types[t].name;
        const auto mask = land.masks.find("type-" + type);
        if (mask == land.masks.end()) continue;
        // No larger than what every sample has room for.
        const Sample* largest = nullptr;
        int room = land.heights.width();
        for (const int index : samples.of_type[t]) {
            const Sample& sample = samples.all[std::size_t(index)];
            const Field<float>& h = sample.land->heights;
            if (!largest || h.size() > largest->land->heights.size()) largest = &sample;
            room = std::min({room, 4 * h.width() / 5, 4 * h.height() / 5});
        }
        const auto [x, y, most] = largest_square(mask->second);
        const int side = std::min(most, room), off = (most - side) / 2;
        write(fmt::format("{}/{}-{}.tif", folder, name, type),
              part(land.heights, x + off, y + off, side, side), land.spacing);
        int number = 0;
        for (const int index : samples.of_type[t]) {
            const Sample& sample = samples.all[std::size_t(index)];
            const Field<float>& h = sample.land->heights;
            for (int i = 0; i < kParts && &sample != largest; ++i) {
                const std::uint64_t hash =
                    hash_of({t, std::uint64_t(index), std::uint64_t(i)});
                write(fmt::format("{}/{}-part-{}.tif", folder, type, ++number),
                      part(h, int(unit(hash) * (h.width() - side)),
                           int(unit(mix(hash)) * (h.height() - side)), side, side),
                      land.spacing);
            }
        }
        write(fmt::format("{}/{}.tif", folder, type), largest->land->heights,
              land.spacing);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 5) return 2;
    Options options;
    options.library = config::load_library(argv[1]);
    options.map = config::load_map(argv[2], options.library);
    const int samples = std::atoi(argv[3]);
    const double spacing = std::atof(argv[4]);
    for (const Optimiser optimiser : {Optimiser::kTexture, Optimiser::kEvolution})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            options.optimiser = optimiser;
            Terrain flat;
            flat.spacing = spacing, flat.heights = Field<float>(samples, samples);
            StepTimes progress;
            Context context;
            context.seed = seed, context.progress = &progress;
            const Terrain land = run(options, flat, context);
            progress.finish();
            const bool texture = optimiser == Optimiser::kTexture;
            fmt::print("{}, seed {}\n", texture ? "texture" : "evolution", seed);
            double levels = 0.0;
            for (const auto& [name, seconds] : progress.steps()) {
                const bool level = name.ends_with(" m");
                if (level) levels += seconds;
                fmt::print("  {:<44} {:7.2f} s{}\n", name, seconds,
                           level ? fmt::format("  {:7.2f} s so far", levels) : "");
            }
            for (const auto& [name, value] : land.figures)
                fmt::print("  {:<44} {:7.3f}\n", name, value);
            if (argc <= 5) continue;
            const std::string name =
                fmt::format("{}-{}", texture ? "texture" : "evolution", seed);
            write(fmt::format("{}/{}.tif", argv[5], name), land.heights, spacing);
            SilentProgress silent;
            const auto level =
                samples_of(options.library,
                           std::vector<std::uint8_t>(options.library.types.size(), 1),
                           spacing, 3, 1, silent);
            write_parts(argv[5], name, land, level.front(), options.library);
        }
}
