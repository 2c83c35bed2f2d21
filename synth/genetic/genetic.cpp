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

// The finest level at which at least half of the samples come from models as fine as the
// level. Texture is of no use on finer ones.
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

// Adds figures of how similar each region is to its type, in all quantities of the
// library (IV.3.2), at the finest level for which there are real samples.
void judge(const Options& options, const LevelSamples& finest, const MapRaster& map,
           Regions regions, Terrain& terrain, Progress& progress) {
    progress.step("genetic: comparing the land with its types");
    Terrain judged;
    judged.heights = terrain.heights, judged.spacing = terrain.spacing;
    while (judged.spacing < 0.99 * finest.spacing) {
        judged.heights = coarser(judged.heights, options.ratio);
        judged.spacing *= options.ratio;
        regions = coarser(regions, options.ratio);
    }
    std::vector<statistics::Type> types;
    std::vector<int> index(options.library.types.size(), -1);
    for (std::size_t t = 0; t < options.library.types.size(); ++t) {
        if (finest.of_type[t].empty()) continue;
        index[t] = int(types.size());
        statistics::Type type{.name = options.library.types[t].name, .examples = {}};
        for (const int s : finest.of_type[t]) {
            const Sample& sample = finest.all[std::size_t(s)];
            Terrain land;
            land.spacing = finest.spacing;
            land.heights = sample.land->heights;
            for (float& h : land.heights) h *= sample.gain;
            type.examples.push_back(statistics::analysis_of(land));
            if (sample.smaller)
                type.examples.back()[std::size_t(statistics::Quantity::kElevation)] = {};
        }
        types.push_back(std::move(type));
    }
    const statistics::Library library(std::move(types));
    const std::vector<statistics::Analysis> of_regions =
        statistics::analyses_of(judged, regions.at, int(regions.types.size()));
    double sum = 0.0, cells = 0.0;
    for (std::size_t r = 0; r < regions.types.size(); ++r) {
        const int type = index[std::size_t(regions.types[r])];
        if (type < 0) continue;
        statistics::Analysis analysis = of_regions[r];
        if (library.types()[std::size_t(type)]
                .examples.front()[std::size_t(statistics::Quantity::kElevation)]
                .count == 0)
            analysis[std::size_t(statistics::Quantity::kElevation)] = {};
        const double similarity = library.similarity(std::size_t(type), analysis);
        terrain.figures[fmt::format("genetic: similarity of '{}'", map.all[r].name)] =
            similarity;
        sum += similarity * double(regions.cells[r]), cells += double(regions.cells[r]);
    }
    if (cells > 0.0) terrain.figures["genetic: similarity"] = sum / cells;
}

// The mean height of each type over its samples with absolute heights; NaN for types
// without any.
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

int most_levels(const Options& options, double spacing) {
    int levels = 1;
    while (levels < kMostLevels &&
           spacing * std::pow(options.ratio, levels) <= 1.001 * options.coarsest)
        ++levels;
    return levels;
}

std::vector<LevelSamples> all_samples(const Options& options,
                                      const std::vector<std::uint8_t>& used,
                                      double spacing, Progress& progress) {
    progress.step("genetic: reading the samples");
    return samples_of(options.library, used, spacing, options.ratio,
                      most_levels(options, spacing), progress);
}

// The map as it was drawn, or, if it asks for automatic regions, with regions made up.
MapOptions drawn_map(const Options& options, const Extent& extent, std::uint64_t seed,
                     Progress& progress) {
    MapOptions drawn = options.map;
    if (drawn.automatic == 0) return drawn;
    std::vector<std::uint8_t> all;
    for (const TypeOptions& type : options.library.types)
        all.push_back(!type.examples.empty());
    const auto means = mean_heights(all_samples(options, all, extent.spacing, progress));
    MapOptions made =
        automatic_map(options.library, means, drawn.automatic, extent, seed);
    drawn.regions = std::move(made.regions), drawn.window = made.window;
    return drawn;
}

// The samples of the used types, from the base level to the finest.
std::vector<LevelSamples> samples_from_base(const Options& options,
                                            const Regions& regions,
                                            const std::vector<std::uint8_t>& used,
                                            const Extent& extent, Progress& progress) {
    std::vector<LevelSamples> samples =
        all_samples(options, used, extent.spacing, progress);
    const int base = base_level(samples, regions, extent.columns, extent.rows,
                                options.ratio, options.coarsest);
    samples.erase(samples.begin(), samples.begin() + base);
    for (const int type : regions.types)
        if (samples.front().of_type[std::size_t(type)].empty())
            throw bad_request(
                "the samples of '{}' are smaller than a gene at {:.4g} m; give larger "
                "ones",
                options.library.types[std::size_t(type)].name, samples.front().spacing);
    return samples;
}

void add_level_figures(const std::vector<LevelDone>& levels, Terrain& terrain) {
    for (const LevelDone& level : levels) {
        if (level.generations.empty()) continue;
        terrain.figures[fmt::format("genetic: fitness at {:g} m", level.spacing)] =
            level.generations.back().fitness;
        if (level.seam_energy > 0.0)
            terrain
                .figures[fmt::format("genetic: seam energy at {:g} m", level.spacing)] =
                level.seam_energy;
    }
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
    const std::uint64_t map_seed = hash_of({context.seed, key("map")});
    const MapOptions drawn = drawn_map(options, extent, map_seed, progress);
    progress.step("genetic: the map");
    const MapRaster map = rasterised(drawn, options.library, extent, map_seed, progress);
    const Regions regions = regions_of(map);
    std::vector<std::uint8_t> used(options.library.types.size());
    for (const int type : regions.types) used[std::size_t(type)] = 1;
    const std::vector<LevelSamples> samples =
        samples_from_base(options, regions, used, extent, progress);

    // Texture makes the levels after `from`, up to `to`; on finer ones samples are too
    // coarse.
    const bool may_use = options.optimiser == Optimiser::kTexture;
    const int from = std::min(may_use ? 1 : 99, int(samples.size()) - 1),
              to = finest_real(samples);
    std::unique_ptr<ByTexture> texture;
    if (may_use && to > from)
        texture = std::make_unique<ByTexture>(options.library, used,
                                              samples[std::size_t(to)].spacing,
                                              context.cache, progress);
    const PlacedFeatures features =
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
    add_level_figures(levels, result);
    show_types(options, map, result);
    return result;
}

}  // namespace cydonia::genetic
