// What a map of kinds of land takes, level by level (Saunders 2006, table VI.1), and how
// good it is, by both optimisers.
//
//     evolution LIBRARY MAP SAMPLES SPACING [FOLDER]
//
// Three seeds each; the last land of each optimiser goes to FOLDER as a GeoTIFF.

#include <fmt/core.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "config/reader/library.h"
#include "config/reader/map.h"
#include "field/dem.h"
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
            if (argc > 5)
                write_geotiff(
                    fmt::format("{}/{}.tif", argv[5], texture ? "texture" : "evolution"),
                    land);
        }
}
