#include "synth/texture/start.h"

#include <algorithm>
#include <cmath>

#include "field/random.h"
#include "synth/texture/places.h"

namespace cydonia::texture {
namespace {

// Cells of the coarsest level that start as one piece of land, each way: smaller pieces
// lose relief, larger ones are copies (bench/realism.sh).
constexpr int kBlock = 6;

// A point of an irrational lattice: points of neighbouring blocks are far apart and no
// part of [0, 1) stays empty for long.
double spread(std::uint64_t key, int bx, int by, double east, double south) {
    const double at = unit(key) + bx * east + by * south;
    return at - std::floor(at);
}

// The land at the middle of a block.
Spot middle_of_block(const Level& level, const Controls& controls, int bx, int by,
                     int cell) {
    const auto drawn = [&](const char* what) {
        return hash_of({controls.seed, key("start"), key(what)});
    };
    double all = 0.0;
    for (const Sheet& s : level.sheets) all += double(s.cells());
    double at = all * spread(drawn("exemplar"), bx, by, 0.6180339887, 0.4142135624);
    int e = 0;
    while (e + 1 < int(level.sheets.size()) &&
           at >= double(level.sheets[std::size_t(e)].cells()))
        at -= double(level.sheets[std::size_t(e++)].cells());
    const Sheet& sheet = level.sheets[std::size_t(e)];
    const std::uint64_t h =
        hash_of({drawn("orientation"), std::uint64_t(std::int64_t{bx}),
                 std::uint64_t(std::int64_t{by})});
    const int o = controls.orientations == 2
                      ? int(h % 2) * 2
                      : int(h % std::uint64_t(controls.orientations));
    // The middle lies where at least half of the block is on the exemplar.
    const auto middle = [&](int size, double share) {
        const double margin = std::min(0.5 * size, 1.0 + 0.25 * kBlock);
        return int((margin + share * (size - 2.0 * margin)) * cell);
    };
    return {
        e, o,
        middle(sheet.width, spread(drawn("east"), bx, by, 0.7548776662, 0.3176721962)),
        middle(sheet.height, spread(drawn("south"), bx, by, 0.5698402910, 0.8191725134))};
}

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

}  // namespace

Synthesis started(const Database& database, const Controls& controls,
                  const Window& window) {
    const int top = window.level;
    const Level& level = database.levels[std::size_t(top)];
    const int cell = 2 << top;

    Synthesis land{window, {window.width, window.height}, {window.width, window.height}};
    const double size = kBlock;
    for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
            const int x = window.x + column, y = window.y + row;
            const Spot middle = middle_of_block(level, controls, floor_div(x, kBlock),
                                                floor_div(y, kBlock), cell);
            const auto from_middle = [&](int at) {
                return int((at - floor_div(at, kBlock) * kBlock + 0.5 - 0.5 * size) *
                           cell);
            };
            const Step s = kTurns(middle.orientation, from_middle(x), from_middle(y));
            land.places(column, row) = place_of(kept_inside(
                middle.moved(s), level.sheets[std::size_t(middle.exemplar)], top));
        }
    }
    return land;
}

}  // namespace cydonia::texture
