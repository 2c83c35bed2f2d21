#include "synth/genetic/genetic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "field/error.h"
#include "field/file_names.h"
#include "field/random.h"
#include "synth/genetic/evolution/by_texture.h"
#include "synth/genetic/evolution/height_field.h"
#include "synth/genetic/explain.h"
#include "synth/genetic/map/map.h"
#include "synth/genetic/placed.h"
#include "synth/statistics/analysis.h"
#include "synth/statistics/similarity.h"

namespace cydonia::genetic {
namespace {

constexpr int kMostLevels = 12;

// Down to where at least half of the samples are as fine as the level: the finest level
// that texture is any use for.
int finest_real(const std::vector<LevelSamples>& samples) {
    for (int level = int(samples.size()) - 1; level > 0; --level) {
        const auto& all = samples[std::size_t(level)].all;
        if (2 * std::ranges::count(all, false, &Sample::smaller) >= std::ssize(all))
            return level;
    }
    return 0;
}

Regions regions_of(const MapRaster& map) {
    Regions regions;
    regions.at = map.regions;
    for (const auto& region : map.all) {
        regions.types.push_back(region.type);
        regions.cells.push_back(region.cells);
    }
    return regions;
}

// "sea floor" as the mask "type-sea-floor". A type whose name clashes with another's so,
// or is not ASCII, keeps its name as it is.
std::vector<std::string> mask_names(const std::vector<TypeOptions>& types) {
    std::vector<std::string> names;
    for (const TypeOptions& type : types) names.push_back(type.name);
    const std::vector<std::string> safe = file_names_of(names);
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = "type-" + (safe[i].find('~') == safe[i].npos ? safe[i] : names[i]);
    return names;
}

void show_types(const Options& options, const MapRaster& map, Terrain& terrain) {
    Field<Rgb8>& picture = terrain.pictures["types"] =
        Field<Rgb8>(map.types.width(), map.types.height());
    const std::vector<std::string> names = mask_names(options.library.types);
    std::vector<Field<float>*> masks(names.size());
    for (std::size_t i = 0; i < map.types.size(); ++i) {
        const std::size_t type = map.types[i];
        const TypeOptions& of = options.library.types[type];
        picture[i] = {of.colour[0], of.colour[1], of.colour[2]};
        if (!masks[type])
            masks[type] = &(terrain.masks[names[type]] =
                                Field<float>(map.types.width(), map.types.height()));
        (*masks[type])[i] = 1.0f;
    }
}

// How like its type each region is, by all that the library judges land by (IV.3.2), on
// the finest level that samples are as fine as: below there is nothing to judge it by.
void judge(const Options& options, const LevelSamples& finest, const MapRaster& map,
           Regions regions, Terrain& terrain, Progress& progress) {
    progress.step("genetic: how like its types the land is");
    Terrain judged;
    judged.heights = terrain.heights, judged.spacing = terrain.spacing;
    while (judged.spacing < 0.99 * finest.spacing) {
        judged.heights = coarser(judged.heights, options.ratio);
        judged.spacing *= options.ratio;
        regions = coarser(regions, options.ratio);
    }
    std::vector<Type> types;
    std::vector<int> index(options.library.types.size(), -1);
    for (std::size_t t = 0; t < options.library.types.size(); ++t) {
        if (finest.of_type[t].empty()) continue;
        index[t] = int(types.size());
        Type type{.name = options.library.types[t].name, .examples = {}};
        for (const int s : finest.of_type[t]) {
            const Sample& sample = finest.all[std::size_t(s)];
            Terrain land;
            land.spacing = finest.spacing;
            land.heights = sample.land->heights;
            for (float& h : land.heights) h *= sample.gain;
            type.examples.push_back(analysis_of(land));
            if (sample.smaller)
                type.examples.back()[std::size_t(Quantity::kElevation)] = {};
        }
        types.push_back(std::move(type));
    }
    const Library library(std::move(types));
    const std::vector<Analysis> of_regions =
        analyses_of(judged, regions.at, int(regions.types.size()));
    double sum = 0.0, cells = 0.0;
    for (std::size_t r = 0; r < regions.types.size(); ++r) {
        const int type = index[std::size_t(regions.types[r])];
        if (type < 0) continue;
        Analysis analysis = of_regions[r];
        if (library.types()[std::size_t(type)]
                .examples.front()[std::size_t(Quantity::kElevation)]
                .count == 0)
            analysis[std::size_t(Quantity::kElevation)] = {};
        const double similarity = library.similarity(std::size_t(type), analysis);
        terrain.figures[fmt::format("genetic: similarity of '{}'", map.all[r].name)] =
            similarity;
        sum += similarity * double(regions.cells[r]), cells += double(regions.cells[r]);
    }
    if (cells > 0.0) terrain.figures["genetic: similarity"] = sum / cells;
}

// Of each type, by its samples where their heights are their own; NaN without any.
std::vector<double> mean_heights(const std::vector<LevelSamples>& samples) {
    std::vector<double> means;
    for (std::size_t t = 0; t < samples.back().of_type.size(); ++t) {
        double sum = 0.0, cells = 0.0;
        for (const LevelSamples& level : samples)
            for (const int s : level.of_type[t]) {
                const Sample& sample = level.all[std::size_t(s)];
                if (sample.smaller) continue;
                const double n = double(sample.width()) * sample.height();
                sum += n * sample.land->mean(0, 0, sample.width(), sample.height());
                cells += n;
            }
        means.push_back(cells > 0.0 ? sum / cells
                                    : std::numeric_limits<double>::quiet_NaN());
    }
    return means;
}

void explain(const std::vector<LevelDone>& levels, const Explain& sinks) {
    for (const LevelDone& level : levels)
        sinks.picture(fmt::format("level-{:g}m", level.spacing),
                      relief_picture(level.heights, level.spacing));
    sinks.picture("fitness", fitness_picture(levels));
    sinks.table("fitness", fitness_table(levels));
}

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    Progress& progress = *context.progress;
    const Extent extent{terrain.heights.width(), terrain.heights.height(),
                        terrain.spacing};
    int levels_at_most = 1;
    while (levels_at_most < kMostLevels &&
           extent.spacing * std::pow(options.ratio, levels_at_most) <=
               1.001 * options.coarsest)
        ++levels_at_most;
    const auto samples_with = [&](const std::vector<std::uint8_t>& used) {
        progress.step("genetic: reading the samples");
        return samples_of(options.library, used, extent.spacing, options.ratio,
                          levels_at_most, progress);
    };
    const std::uint64_t map_seed = hash_of({context.seed, key("map")});
    MapOptions drawn = options.map;
    if (drawn.automatic > 0) {
        std::vector<std::uint8_t> all;
        for (const TypeOptions& type : options.library.types)
            all.push_back(!type.examples.empty());
        const MapOptions made =
            automatic_map(options.library, mean_heights(samples_with(all)),
                          drawn.automatic, extent, map_seed);
        drawn.regions = made.regions, drawn.window = made.window;
    }
    progress.step("genetic: the map");
    const MapRaster map = rasterised(drawn, options.library, extent, map_seed, progress);
    const Regions regions = regions_of(map);

    std::vector<std::uint8_t> used(options.library.types.size());
    for (const int type : regions.types) used[std::size_t(type)] = 1;
    std::vector<LevelSamples> samples = samples_with(used);
    const int base = base_level(samples, regions, extent.columns, extent.rows,
                                options.ratio, options.coarsest);
    samples.erase(samples.begin(), samples.begin() + base);
    for (const int type : regions.types)
        if (samples.front().of_type[std::size_t(type)].empty())
            throw bad_request(
                "the samples of '{}' are smaller than a gene at {:.4g} m; give larger "
                "ones",
                options.library.types[std::size_t(type)].name, samples.front().spacing);

    // Where texture takes over, and where samples are too coarse for it.
    std::unique_ptr<ByTexture> texture;
    const int from = std::min(options.optimiser == Optimiser::kTexture ? 1 : 99,
                              int(samples.size()) - 1),
              to = finest_real(samples);
    if (options.optimiser == Optimiser::kTexture && to > from)
        texture = std::make_unique<ByTexture>(options.library, used,
                                              samples[std::size_t(to)].spacing,
                                              context.cache, progress);
    const Features features =
        features_of(options.points, options.curves, extent, progress);
    std::vector<LevelDone> levels =
        height_field(regions, samples, options.ratio, options.evolution, features,
                     texture.get(), samples[std::size_t(from)].spacing,
                     samples[std::size_t(to)].spacing, context.seed, progress);
    if (context.explain) explain(levels, *context.explain);

    Terrain result;
    result.spacing = terrain.spacing;
    result.heights = std::move(levels.back().heights);
    judge(options, samples[std::size_t(to)], map, regions, result, progress);
    result.figures["genetic: regions"] = double(regions.types.size());
    result.figures["genetic: levels"] = double(samples.size());
    for (const LevelDone& level : levels) {
        if (level.generations.empty()) continue;
        result.figures[fmt::format("genetic: fitness at {:g} m", level.spacing)] =
            level.generations.back().fitness;
        if (level.seam_energy > 0.0)
            result.figures[fmt::format("genetic: seam energy at {:g} m", level.spacing)] =
                level.seam_energy;
    }
    show_types(options, map, result);
    return result;
}

}  // namespace cydonia::genetic
