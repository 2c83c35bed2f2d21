#include "synth/texture/texture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "field/strokes.h"
#include "synth/hydrology/breach.h"
#include "synth/texture/database/database_file.h"
#include "synth/texture/maker.h"
#include "synth/texture/report.h"
#include "synth/texture/synthesis/keeping.h"
#include "synth/texture/synthesis/origins.h"

namespace cydonia::texture {
namespace {

// The frozen cells, from the finest level on.
std::optional<CellSet> frozen_region(const Options& options, const Maker& maker) {
    if (!options.frozen) return std::nullopt;
    const double cell = maker.ground().spacing * (1 << maker.controls().finest);
    const Window window{maker.controls().finest, 0, 0,
                        static_cast<int>(std::ceil(maker.ground().width / cell)),
                        static_cast<int>(std::ceil(maker.ground().depth / cell))};
    const Field<float> white = read_grey_at(*options.frozen, window.width, window.height);
    // The land around the terrain that its border depends on is frozen, too.
    const Window all = window.grown(2 * kReadOut);
    Field<std::uint8_t> inside(all.width, all.height);
    for (int y = 0; y < all.height; ++y)
        for (int x = 0; x < all.width; ++x)
            inside(x, y) =
                white(std::clamp(x - 2 * kReadOut, 0, window.width - 1),
                      std::clamp(y - 2 * kReadOut, 0, window.height - 1)) >= 0.5f;
    return cell_set_of(all, std::move(inside), maker.levels() - maker.controls().finest);
}

// Whether every origin lies on an exemplar. The file's checksum guards against accidents
// only.
bool all_on_exemplars(const Run& run, const Database& database) {
    for (std::size_t level = 0; level < run.passes.size(); ++level) {
        if (level >= database.levels.size()) return false;
        const auto& sheets = database.levels[level].sheets;
        for (const Synthesis& pass : run.passes[level])
            for (const Origin& place : pass.origins) {
                const Spot spot = spot_of(place);
                if (std::size_t(spot.exemplar) >= sheets.size()) return false;
                const Sheet& sheet = sheets[std::size_t(spot.exemplar)];
                if (kept_inside(spot, sheet, static_cast<int>(level)) != spot)
                    return false;
            }
    }
    return true;
}

// The last run, if it used the same exemplars.
std::optional<Run> last_run(const Context& context, const Database& exemplars,
                            std::uint64_t database) {
    if (!context.memory) return std::nullopt;
    std::optional<Run> last = load_run(context.memory->last);
    if (!last) return std::nullopt;
    if (last->database == database && all_on_exemplars(*last, exemplars)) return last;
    context.progress->note(
        "texture: the exemplars have changed since the last run: nothing is kept of it");
    return std::nullopt;
}

Synthesis coherent_synthesis(const Options& options, const Maker& maker,
                             const std::optional<CellSet>& frozen, const Context& context,
                             const Window& window) {
    const std::uint64_t database = database_key(options);
    Keeping keeping(maker.guidance(), last_run(context, maker.database(), database),
                    frozen, maker.controls(), maker.levels());
    Guidance guidance = maker.guidance();
    guidance.pinned = [&](const Window& w, int pass) { return keeping.pinned(w, pass); };
    Synthesis land = synthesised(maker.database(), maker.controls(), guidance, window,
                                 &keeping.passes(), *context.progress);
    if (context.memory) store_run(context.memory->next, keeping.finished(database));
    return land;
}

// 1 at samples whose heights may not change, as they are frozen or pasted.
Field<std::uint8_t> locked_samples(const Maker& maker,
                                   const std::optional<CellSet>& frozen,
                                   const Window& window, int width, int height) {
    const PinnedRegion pasted =
        maker.guidance().pinned ? maker.guidance().pinned(window, 0) : PinnedRegion{};
    Field<std::uint8_t> locked(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int cx = maker.cell_of(x), cy = maker.cell_of(y);
            locked(x, y) = (frozen && frozen->at(window.level).holds(cx, cy)) ||
                           (!pasted.weights.empty() &&
                            pasted.weights(cx - window.x, cy - window.y) == 0.0f);
        }
    }
    return locked;
}

void let_out(Terrain& terrain, const Field<std::uint8_t>& locked,
             const Context& context) {
    context.progress->step("texture: channels that end nowhere");
    const hydrology::Breached breached =
        hydrology::breach(terrain.heights, terrain.spacing, locked);
    terrain.figures["texture: channels let out"] = breached.cut;
    terrain.figures["texture: deepest cut, m"] = breached.deepest;
}

}  // namespace

Terrain run(const Options& options, const Terrain& terrain, const Context& context) {
    const int width = terrain.heights.width(), height = terrain.heights.height();
    const Maker maker(options, {width, height, terrain.spacing}, context);

    const std::optional<CellSet> frozen = frozen_region(options, maker);
    context.progress->step("texture: synthesis");
    const Window window = maker.window_of(0, 0, width, height);
    const Synthesis land =
        options.coherent
            ? coherent_synthesis(options, maker, frozen, context, window)
            : synthesised(maker.database(), maker.controls(), maker.guidance(), window,
                          nullptr, *context.progress);

    Terrain result;
    result.spacing = terrain.spacing;
    result.heights = maker.heights(land, 0, 0, width, height);
    if (options.breach)
        let_out(result, locked_samples(maker, frozen, window, width, height), context);
    report(options, maker, land, result, context);
    return result;
}

Field<float> tile(const Options& options, const Extent& extent, const Context& context,
                  int x, int y, int width, int height) {
    const Maker maker(options, extent, context);
    context.progress->step("texture: synthesis");
    const Synthesis land =
        synthesised(maker.database(), maker.controls(), maker.guidance(),
                    maker.window_of(x, y, width, height), nullptr, *context.progress);
    return maker.heights(land, x, y, width, height);
}

}  // namespace cydonia::texture
