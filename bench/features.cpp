// Rusnell 2009, chapter 5: how long the scenes that cast an image take, stage by stage
// (the least of some runs), and how well the image is cast: hard sun, 2x2 rays a cell.
// With --look their hillshades and overlays.
//
//     build/bench/bench/features [--look FOLDER] [--set KEY=VALUE]... SCENE...
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "config/reader/scene.h"
#include "field/error.h"
#include "field/image.h"
#include "field/quantise.h"
#include "field/random.h"
#include "render/maps/hillshade.h"
#include "render/shadow/caster.h"
#include "render/shadow/overlay.h"
#include "render/shadow/score.h"

using namespace cydonia;
namespace fs = std::filesystem;

namespace {

constexpr int kRuns = 3;

struct Request {
    fs::path look;
    std::vector<std::string> changes;
    std::vector<fs::path> scenes;
};

Request request_of(int argc, char** argv) {
    Request request;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool takes_value = word == "--look" || word == "--set";
        if (takes_value && i + 1 == argc) throw bad_request("{} needs a value", word);
        if (word == "--look")
            request.look = argv[++i];
        else if (word == "--set")
            request.changes.push_back(argv[++i]);
        else
            request.scenes.push_back(word);
    }
    if (request.scenes.empty())
        throw bad_request("features [--look FOLDER] [--set KEY=VALUE]... SCENE...");
    return request;
}

// As the program runs the stages (app/pipeline/land.cpp).
Terrain land_of(const config::SceneSpec& spec, std::vector<double>& seconds) {
    const config::TerrainSpec& t = spec.terrain;
    const double spacing = std::max(t.width, t.depth) / t.samples;
    const auto cells = [&](double metres) {
        return static_cast<int>(std::lround(metres / spacing));
    };
    Terrain terrain{Field<float>(cells(t.width), cells(t.depth)), spacing, {}, {}, {}};
    SilentProgress silent;
    seconds.resize(spec.stages.size(), 1e9);
    for (std::size_t i = 0; i < spec.stages.size(); ++i) {
        const bench::Stopwatch watch;
        terrain = run(spec.stages[i].options, terrain,
                      {.seed = hash_of({spec.seed, i, key("stage")}),
                       .cast = {},
                       .progress = &silent});
        seconds[i] = std::min(seconds[i], watch.seconds());
    }
    return terrain;
}

void measure(const fs::path& file, const Request& request) {
    const auto scene = config::Scene::load(file, request.changes);
    std::vector<double> seconds;
    Terrain terrain;
    for (int i = 0; i < kRuns; ++i) terrain = land_of(scene.at(0), seconds);
    const std::string name = fs::absolute(file).parent_path().filename().string();
    const render::Caster caster(heights_of(quantised(terrain.heights)), terrain.spacing);
    double sum = 0.0;
    std::string stages;
    for (double s : seconds) {
        sum += s;
        stages += fmt::format("{}{:.2f}", stages.empty() ? "" : " + ", s);
    }
    for (const ShadowImage& image : terrain.shadows) {
        const auto cast = caster.shadow(image.sun, 2);
        const render::ShadowScore score = render::score(cast, image.target, image.window);
        fmt::print(
            "{:16} {:5} {:14} {:5.2f} s   IoU {:.3f}   precision {:.3f}   recall "
            "{:.3f}\n",
            name, terrain.heights.width(), stages, sum, score.iou, score.precision,
            score.recall);
        if (request.look.empty()) continue;
        const Field<float> grey(terrain.heights.width(), terrain.heights.height(), 0.9f);
        write_png(request.look / (name + "-overlay.png"),
                  render::overlay(cast, image, grey));
    }
    if (!request.look.empty())
        write_png(request.look / (name + "-land.png"), render::hillshade(terrain));
}

}  // namespace

int main(int argc, char** argv) try {
    const Request request = request_of(argc, argv);
    fmt::print("{:16} {:>5} {:14} {:>5}\n", "scene", "side", "stages, s", "sum");
    for (const fs::path& file : request.scenes) measure(file, request);
    return 0;
} catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return static_cast<int>(error.code());
}
