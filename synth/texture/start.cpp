#include "synth/texture/start.h"

#include <algorithm>
#include <cstdlib>

#include "field/random.h"
#include "synth/texture/places.h"

namespace cydonia::texture {
namespace {

// Cells of the coarsest level that start as one piece of land, each way.
int kBlock = getenv("BLOCK") ? atoi(getenv("BLOCK")) : 4;

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

}  // namespace

Synthesis started(const Database& database, const Controls& controls,
                  const Window& window) {
    const int top = window.level;
    const Level& level = database.levels[std::size_t(top)];
    const int cell = 2 << top;
    std::uint64_t all = 0;
    for (const Sheet& s : level.sheets) all += s.cells();

    Synthesis land{window, {window.width, window.height}, {window.width, window.height}};
    for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
            const int x = window.x + column, y = window.y + row;
            const int bx = floor_div(x, kBlock), by = floor_div(y, kBlock);
            std::uint64_t h =
                hash_of({controls.seed, key("start"), std::uint64_t(std::int64_t{bx}),
                         std::uint64_t(std::int64_t{by})});
            std::uint64_t at = h % all;
            int e = 0;
            while (at >= level.sheets[std::size_t(e)].cells())
                at -= level.sheets[std::size_t(e++)].cells();
            const Sheet& sheet = level.sheets[std::size_t(e)];
            h = mix(h);
            const int o = controls.orientations == 2
                              ? int(h % 2) * 2
                              : int(h % std::uint64_t(controls.orientations));
            // The middle of the block on the exemplar, as far inside as it goes.
            const auto middle = [&](int size, double share) {
                const double margin = std::min(0.5 * size, 3.0 + 0.5 * kBlock);
                return int((margin + share * (size - 2.0 * margin)) * cell);
            };
            h = mix(h);
            const int mx = middle(sheet.width, unit(h));
            h = mix(h);
            const int my = middle(sheet.height, unit(h));
            const Step s = kTurns(o, int((x - bx * kBlock + 0.5 - 0.5 * kBlock) * cell),
                                  int((y - by * kBlock + 0.5 - 0.5 * kBlock) * cell));
            const Spot spot = kept_inside({e, o, mx + s.x, my + s.y}, sheet, top);
            land.places(column, row) = place_of(spot);
        }
    }
    return land;
}

}  // namespace cydonia::texture
