#include "synth/texture/synthesis/synthesis.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/parallel.h"
#include "field/random.h"
#include "synth/texture/synthesis/correction.h"
#include "synth/texture/synthesis/origins.h"
#include "synth/texture/synthesis/start.h"

namespace cydonia::texture {
namespace {

// Eq. 1 and 2. On the two finest levels positions are snapped to the centres of cells,
// which keeps the exemplar's finest detail (docs/papers.md, Gain 2015, trial 1).
Synthesis upsampled(const Synthesis& coarse, const Database& database,
                    const Controls& controls, const Window& window) {
    const Level& level = database.levels[std::size_t(window.level)];
    const int half = 1 << window.level;  // half cells of level 0 in half a cell
    const bool snapped = is_snapped(window.level, controls);
    const double reach = 2.0 * half * controls.jitter;
    Synthesis fine{window, {window.width, window.height}, {window.width, window.height}};
    parallel_for(window.height, 16, [&](int row) {
        const int y = window.y + row;
        for (int column = 0; column < window.width; ++column) {
            const int x = window.x + column;
            const int px = (x >> 1) - coarse.window.x, py = (y >> 1) - coarse.window.y;
            const Origin parent = coarse.origins(px, py);
            const Step s = turned(parent.orientation(),
                                  {(x & 1) ? half : -half, (y & 1) ? half : -half});
            double jx = 0.0, jy = 0.0;
            if (!snapped) {
                const std::uint64_t h = hash_of(
                    {controls.seed, key("jitter"), std::uint64_t(window.level),
                     std::uint64_t(std::int64_t{x}), std::uint64_t(std::int64_t{y})});
                jx = reach * signed_unit(h);
                jy = reach * signed_unit(mix(h));
            }
            Spot spot = spot_of(parent).moved(
                {s.x + int(std::lround(jx)), s.y + int(std::lround(jy))});
            spot =
                kept_inside(spot, level.sheets[std::size_t(spot.exemplar)], window.level);
            if (snapped)
                spot = {spot.exemplar, spot.orientation,
                        texture::snapped(spot.x, window.level),
                        texture::snapped(spot.y, window.level)};
            fine.origins(column, row) = origin_of(spot);
            fine.offsets(column, row) = coarse.offsets(px, py);
        }
    });
    return fine;
}

Synthesis cut(const Synthesis& land, const Window& window) {
    Synthesis part{window, {window.width, window.height}, {window.width, window.height}};
    for (int y = 0; y < window.height; ++y) {
        const int x0 = window.x - land.window.x, y0 = window.y - land.window.y;
        std::copy_n(land.origins.row(y0 + y).begin() + x0, window.width,
                    part.origins.row(y).begin());
        std::copy_n(land.offsets.row(y0 + y).begin() + x0, window.width,
                    part.offsets.row(y).begin());
    }
    return part;
}

PinnedRegion pinned_at(const Guidance& guidance, const Window& window, int pass) {
    return guidance.pinned ? guidance.pinned(window, pass) : PinnedRegion{};
}

}  // namespace

Synthesis synthesised(const Database& database, const Controls& controls,
                      const Guidance& guidance, const Window& window, Recording* record,
                      Progress& progress) {
    // For each level the window that must be exact, and the larger one that is computed
    // for that.
    const int top = static_cast<int>(database.levels.size()) - 1;
    std::vector<Window> worked(std::size_t(top) + 1);
    Window needed = window;
    double cells = 0.0;
    for (int level = controls.finest; level <= top; ++level) {
        Window& w = worked[std::size_t(level)];
        w = needed.grown(kCorrectionHalo + (guidance.pulls ? kLiftHalo : 0));
        needed = w.coarser();
        cells += double(w.width) * w.height;
    }

    const auto types_at = [&](int level) {
        return guidance.types && !is_snapped(level, controls)
                   ? guidance.types(worked[std::size_t(level)])
                   : Field<TypeSet>();
    };
    const Layout layout = start_of(database, controls);
    Synthesis land = started(database, layout, types_at(top), worked[std::size_t(top)]);
    if (record) record->assign(std::size_t(top) + 1, {});
    double done = 0.0;
    for (int level = top; level >= controls.finest; --level) {
        const Window& w = worked[std::size_t(level)];
        if (level < top) land = upsampled(land, database, controls, w);
        const CellGuidance asked{guidance.pulls ? guidance.pulls(w) : Field<Pull>(),
                                 types_at(level), guidance.types != nullptr};
        // On levels where types are no longer requested the cells do not say whether they
        // were.
        const bool sorted = asked.typed && is_snapped(level, controls);
        if (level == layout.level && !sorted)
            cut_out(land, database, layout, asked.types);
        const auto note = [&] {
            if (record) (*record)[std::size_t(level)].push_back(land);
        };
        for (int pass = 0; pass < kPasses; ++pass) {
            correct(land, database, controls, asked, pinned_at(guidance, w, pass), pass);
            note();
            done += double(w.width) * w.height / (kPasses * cells);
            progress.report(done);
        }
        if (guidance.pulls) {
            lift(land, database, asked, pinned_at(guidance, w, kPasses));
            note();
        }
    }
    return cut(land, window);
}

}  // namespace cydonia::texture
