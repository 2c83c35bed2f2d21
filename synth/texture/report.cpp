#include "synth/texture/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "field/parallel.h"
#include "synth/hydrology/depressions.h"
#include "synth/texture/constraints/constraint_errors.h"
#include "synth/texture/database/types.h"
#include "synth/texture/synthesis/origins.h"
#include "synth/texture/synthesis/patches.h"

namespace cydonia::texture {
namespace {

// 1 at cells whose height is outside the exemplars' range (docs/papers.md, Gain 2015, 6).
Field<float> outside_range(const Field<float>& heights, const Database& database) {
    Field<float> outside(heights.width(), heights.height());
    for (std::size_t i = 0; i < heights.size(); ++i)
        outside[i] =
            heights[i] < database.lowest || heights[i] > database.highest ? 1.0f : 0.0f;
    return outside;
}

double share(const Field<float>& mask) {
    double sum = 0.0;
    for (const float value : mask) sum += value;
    return sum / static_cast<double>(mask.size());
}

// The type of the exemplar's cell that a cell came from: an index in Options::types, or
// kNoType.
std::uint8_t type_at(const Maker& maker, const Synthesis& land, int x, int y) {
    const Window& w = land.window;
    const Level& level = maker.database().levels[std::size_t(w.level)];
    const Spot spot = spot_of(land.origins(x, y));
    const Sheet& sheet = level.sheets[std::size_t(spot.exemplar)];
    return level.types[sheet.index(spot.x >> (w.level + 1), spot.y >> (w.level + 1))];
}

// Adds a mask for each type, such as "type-walls", with 1 where the land is of that type.
// Looks, things and passes use them.
void add_type_masks(const Options& options, const Maker& maker, const Synthesis& land,
                    Terrain& terrain) {
    std::vector<Field<float>*> masks;
    for (const Type& type : options.types)
        masks.push_back(&(terrain.masks["type-" + type.name] = Field<float>(
                              terrain.heights.width(), terrain.heights.height())));
    parallel_for(terrain.heights.height(), 16, [&](int y) {
        for (int x = 0; x < terrain.heights.width(); ++x) {
            const std::uint8_t type = type_at(maker, land, x, y);
            if (type < masks.size()) (*masks[type])(x, y) = 1.0f;
        }
    });
}

// The share of the cells with a requested type that have it; 1 where no type is
// requested.
double typed_share(const Maker& maker, const Synthesis& land) {
    const Window& w = land.window;
    Window guided = w;
    while (guided.level < w.level + kFinestGuided) guided = guided.coarser();
    const Field<TypeSet> sets = maker.guidance().types(guided);
    std::int64_t asked = 0, met = 0;
    for (int y = 0; y < w.height; ++y) {
        for (int x = 0; x < w.width; ++x) {
            const TypeSet set = sets(((w.x + x) >> kFinestGuided) - guided.x,
                                     ((w.y + y) >> kFinestGuided) - guided.y);
            if (set == kAnyType) continue;
            const std::uint8_t type = type_at(maker, land, x, y);
            ++asked;
            met += type < kMostTypes && (set >> type & 1u);
        }
    }
    return asked > 0 ? double(met) / double(asked) : 1.0;
}

void report_constraints(const Maker& maker, Terrain& terrain) {
    const ConstraintErrors errors =
        constraint_errors(maker.geometry(), terrain.heights, terrain.spacing);
    terrain.figures["texture: constraint error, RMS, m"] = errors.all.rms;
    terrain.figures["texture: constraint error, most, m"] = errors.all.max;
    for (const ConstraintError& e : errors.each) {
        if (e.sites == 0) continue;
        terrain.figures[fmt::format("texture: error of '{}', RMS, m", e.name)] = e.rms;
        terrain.figures[fmt::format("texture: error of '{}', most, m", e.name)] = e.max;
    }
}

}  // namespace

void report(const Options& options, const Maker& maker, const Synthesis& land,
            Terrain& terrain, const Context& context) {
    auto& figures = terrain.figures;
    Field<float>& outside = terrain.masks["outside-exemplars"] =
        outside_range(terrain.heights, maker.database());
    figures["texture: outside the exemplars' heights, share"] = share(outside);

    const PatchFigures patches =
        patch_figures(maker.database(), land.origins, land.window.level);
    figures["texture: patches"] = patches.patches;
    figures["texture: patch size, typical, cells"] = double(patches.typical);
    figures["texture: patch size, largest, cells"] = double(patches.largest);
    figures["texture: coherent cells, share"] = patches.coherent;
    figures["texture: exemplars' blocks used, share"] = patches.used;
    terrain.pictures["sources"] =
        source_map(maker.database(), land.origins, land.window.level);

    if (!options.types.empty()) add_type_masks(options, maker, land, terrain);
    if (!maker.geometry().empty()) report_constraints(maker, terrain);
    if (maker.guidance().types)
        figures["texture: cells of the asked type, share"] = typed_share(maker, land);

    hydrology::Depressions ends = hydrology::depressions_of(terrain.heights);
    figures["texture: channels that end nowhere"] = ends.count;
    figures["texture: deepest of them, m"] = ends.deepest;
    figures["texture: pits per 1000"] = hydrology::pits_per_1000(terrain.heights);
    if (!options.breach && ends.count > 0)
        context.progress->note(fmt::format(
            "texture: {} channels end nowhere, the deepest in {:.1f} m of water "
            "(masks/depressions.png); breach = true lets them out",
            ends.count, double(ends.deepest)));
    terrain.masks["depressions"] = std::move(ends.mask);
}

}  // namespace cydonia::texture
