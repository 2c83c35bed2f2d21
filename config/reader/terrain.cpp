#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "config/reader/readers.h"

namespace cydonia::config {
namespace {

template <class Options>
StageOptions stage_of(Table& t) {
    Options options;
    read(t, options);
    return options;
}

// Every method by its name, and what reads it.
constexpr Name<StageOptions (*)(Table&)> kMethods[] = {
    {"dem", stage_of<dem::Options>},
    {"detail", stage_of<detail::Options>},
    {"distance", stage_of<distance::Options>},
    {"genetic", stage_of<genetic::Options>},
    {"pareidolia", stage_of<pareidolia::Options>},
    {"sketch", stage_of<sketch::Options>},
    {"texture", stage_of<texture::Options>},
};

constexpr std::size_t kMostStages = 64;
constexpr int kMostSamples = 16384;
constexpr int kMostTiledSamples = 65536;
constexpr int kMostTiles = 64;  // a side

// Land of more samples than memory holds.
void check_tiles(Table& t, const TerrainSpec& terrain,
                 const std::vector<StageSpec>& stages) {
    const auto [samples, tiles] = std::pair(terrain.samples, terrain.tiles);
    t.check(samples <= kMostSamples || tiles > 0, {"samples"},
            fmt::format("more than {} samples are made in tiles: add tiles = 2048",
                        kMostSamples));
    if (tiles == 0) return;
    t.check(tiles % 256 == 0, {"tiles"}, "must be a multiple of 256");
    t.check(samples <= kMostTiles * tiles, {"tiles"},
            fmt::format("at most {} a side: let them have {} samples or more", kMostTiles,
                        (samples - 1) / kMostTiles / 256 * 256 + 256));
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const Method method = method_of(stages[i].options);
        t.check(method.whole_because.empty(), {"tiles"},
                fmt::format("land of stage[{}] cannot be made in tiles: {}", i,
                            method.whole_because));
        t.check(method.makes_land == (i == 0), {"tiles"},
                "land in tiles has one stage that makes it, and details after that");
    }
}

}  // namespace

void read(Table& t, StageSpec& stage) {
    if (t.describes()) {
        for (const auto& [name, stage_options] : kMethods)
            t.variant("method", name, stage_options);
        return;
    }
    StageOptions (*options_of)(Table&) = nullptr;
    if (t.required("method", options_of, one_of(kMethods)))
        stage.options = options_of(t);
    else
        t.ignore_unknown();  // without a method, no key can be judged
    stage.text = t.record().text();
    stage.sources = t.record().sources;
}

void read(Table& t, TerrainTable& out) {
    auto& [terrain, stages] = out;
    std::array<double, 2> extent{terrain.width, terrain.depth};
    t.field("extent", extent, Number{above_to(0.0, 1e7)});
    t.field("samples", terrain.samples, Whole{2, kMostTiledSamples});
    t.field("tiles", terrain.tiles, Whole{0, 8192});
    const auto [shorter, longer] = std::minmax(extent[0], extent[1]);
    t.check(terrain.samples * shorter >= 2.0 * longer, {"extent", "samples"},
            "too narrow: the shorter side would have less than 2 samples");
    terrain.width = extent[0];
    terrain.depth = extent[1];
    t.tables("stage", stages, kMostStages);
    t.check(!stages.empty(), {"stage"}, "a scene needs at least one [[terrain.stage]]");
    check_tiles(t, terrain, stages);
}

}  // namespace cydonia::config
