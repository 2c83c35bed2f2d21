#include <fmt/format.h>

#include <algorithm>

#include "config/reader/library.h"
#include "config/reader/map.h"
#include "config/reader/readers.h"
#include "config/reader/texture.h"
#include "field/error.h"

namespace cydonia::config {

using genetic::EvolutionOptions;
using genetic::MapOptions;
using genetic::MapRegion;
using genetic::Optimiser;
using genetic::Options;

namespace {

constexpr std::size_t kMostRegions = 4096, kMostFeatures = 1024, kMostVertices = 65536;
constexpr Number kShare{from(0.0, 1.0)};
constexpr std::size_t kTextureTypes = 32;  // that texture can tell apart

constexpr Name<Optimiser> kOptimisers[] = {{"texture", Optimiser::kTexture},
                                           {"evolution", Optimiser::kEvolution}};

// Reports mistakes in a file that the scene names where the scene names it.
template <class Load>
void load(Table& t, std::string_view key, const Load& load) {
    try {
        load();
    } catch (const Error& error) {
        t.check(false, {key}, error.what());
    }
}

void read_library(Table& t, Options& o) {
    Source file;
    if (!t.required("library", file, File{}) || t.describes()) return;
    load(t, "library", [&] {
        o.library = load_library(file.path);
        std::size_t number = 0;
        for (const auto& type : o.library.types)
            for (const auto& example : type.examples)
                t.shipped(fmt::format("library[{}]", number++), example.source.path);
    });
}

void read_map(Table& t, Options& o) {
    std::optional<Source> file;
    t.field("map", file, File{});
    if (file && !t.describes())
        load(t, "map", [&] { o.map = load_map(file->path, o.library); });
    std::vector<MapRegion> drawn;
    t.tables("region", drawn, kMostRegions);
    t.field("automatic", o.map.automatic, Whole{0, 1000});
    t.check(int(file.has_value()) + int(!drawn.empty()) + int(o.map.automatic > 0) == 1,
            {"map", "region", "automatic"},
            "needs one of a map, [[terrain.stage.region]], or automatic = 12 for regions "
            "that are made up");
    if (!drawn.empty()) o.map.regions = std::move(drawn);
    t.field("window", o.map.window, Number{from(-1e9, 1e9)});
    t.check(o.map.window[0] < o.map.window[2] && o.map.window[1] < o.map.window[3],
            {"window"},
            "must be west, south, east and north in the map's units, with west below "
            "east and south below north");
    t.field("refine", o.map.refine, Flag{});
    t.field("smoothness", o.map.smoothness, kShare);
    t.field("envelope", o.map.envelope, Number{from(0.0, 1e7)});
    t.only_if(o.map.refine, {"smoothness", "envelope"}, "refine = true");

    for (std::size_t i = 0; i < o.map.regions.size() && !t.describes(); ++i) {
        const MapRegion& region = o.map.regions[i];
        std::vector<std::string> names;
        for (const auto& type : o.library.types) names.push_back(type.name);
        if (std::ranges::find(names, region.type) == names.end() && !names.empty())
            t.check(
                false, {"map", "region"},
                fmt::format("region '{}': the library has no type '{}'{}", region.name,
                            region.type, suggestion(region.type, names)));
    }
}

}  // namespace

void read(Table& t, MapRegion& region) {
    t.required("type", region.type, Text{64});
    region.name = region.type;
    t.field("name", region.name, Text{64});
    genetic::Outline outline;
    t.required("outline", outline, Number{from(-1e9, 1e9)});
    t.check(outline.size() >= 3 && outline.size() <= kMostVertices, {"outline"},
            fmt::format("needs 3 to {} corners", kMostVertices));
    region.outlines = {std::move(outline)};
}

void read(Table& t, EvolutionOptions& e) {
    t.field("gene", e.gene, Whole{6, 64});
    t.field("overlap", e.overlap, Number{from(0.05, 0.5)});
    t.field("population", e.population, Whole{1, 200});
    t.field("cycles", e.cycles, Whole{0, 1000});
    t.field("mutation", e.mutation, kShare);
    t.field("elitism", e.elitism, kShare);
    t.field("selection", e.selection, Number{above_to(0.0, 1.0)});
    t.field("alpha", e.alpha, kShare);
    t.field("crossed", e.crossed, Whole{1, 64});
}

void read(Table& t, Options& o) {
    read_library(t, o);
    read_map(t, o);
    t.field("ratio", o.ratio, Whole{2, 3});
    t.field("coarsest", o.coarsest, Number{above_to(0.0, 1e6)});
    t.field("optimiser", o.optimiser, one_of(kOptimisers));
    t.check(
        o.optimiser != Optimiser::kTexture || o.library.types.size() <= kTextureTypes,
        {"optimiser", "library"},
        fmt::format(
            "the texture optimiser distinguishes {} types, and the library has {}; set "
            "optimiser = \"evolution\"",
            kTextureTypes, o.library.types.size()));
    t.table("evolution", o.evolution);
    TextureNames names;
    t.tables("point", o.points, kMostFeatures, names);
    t.tables("curve", o.curves, kMostFeatures, names);
}

}  // namespace cydonia::config
