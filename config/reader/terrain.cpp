#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "config/reader/readers.h"

namespace cydonia::config {
namespace {

using StageReader = StageOptions (*)(Table&);

template <class Options>
concept HasReader = requires(Table& t, Options& o) {
    read(t, o);
};

template <class Options>
StageOptions stage_of(Table& t) {
    static_assert(
        HasReader<Options>,
        "This method has no reader: declare void read(Table&, METHOD::Options&) "
        "in config/reader/readers.h, and define it in a file beside it.");
    Options options;
    if constexpr (HasReader<Options>) read(t, options);
    return options;
}

template <class... Options>
std::vector<Name<StageReader>> readers_of(std::type_identity<std::variant<Options...>>) {
    std::vector<Name<StageReader>> readers{
        {method_of(StageOptions(Options{})).name, stage_of<Options>}...};
    std::ranges::sort(readers, {}, &Name<StageReader>::name);
    return readers;
}

// The readers of all methods in synth/stage.h, by the methods' names.
const std::vector<Name<StageReader>>& stage_readers() {
    static const auto readers = readers_of(std::type_identity<StageOptions>{});
    return readers;
}

constexpr std::size_t kMostStages = 64;
constexpr int kMostSamples = 16384;
constexpr int kMostTiledSamples = 65536;
constexpr int kMostTiles = 64;  // a side

// Checks the options of land with more samples than memory can hold.
void check_tiles(Table& t, const TerrainSpec& terrain,
                 const std::vector<StageSpec>& stages) {
    const auto [samples, tiles] = std::pair(terrain.samples, terrain.tiles);
    t.check(samples <= kMostSamples || tiles > 0, {"samples"},
            fmt::format("more than {} samples are made in tiles: add tiles = 2048",
                        kMostSamples));
    if (tiles == 0) return;
    t.check(tiles % 256 == 0, {"tiles"}, "must be a multiple of 256");
    t.check(
        samples <= kMostTiles * tiles, {"tiles"},
        fmt::format("at most {} tiles along a side are possible: set tiles to {} or more",
                    kMostTiles, (samples - 1) / kMostTiles / 256 * 256 + 256));
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const Method method = method_of(stages[i].options);
        t.check(method.whole_because.empty(), {"tiles"},
                fmt::format("land of stage[{}] cannot be made in tiles: {}", i,
                            method.whole_because));
        t.check(method.makes_land == (i == 0), {"tiles"},
                "land in tiles needs a first stage that makes it, and only detail stages "
                "after that");
    }
}

}  // namespace

void read(Table& t, StageSpec& stage) {
    if (t.describes()) {
        for (const auto& [name, reader] : stage_readers())
            t.variant("method", name, reader);
        return;
    }
    StageReader reader = nullptr;
    if (t.required("method", reader, OneOf<StageReader>{stage_readers()}))
        stage.options = reader(t);
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
