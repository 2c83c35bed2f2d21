#include "synth/texture/start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "field/random.h"
#include "synth/texture/places.h"

namespace cydonia::texture {
namespace {

// Cells of the coarsest level that start as one piece of land, each way: smaller pieces
// lose relief, larger ones are copies (bench/realism.sh).
constexpr int kBlock = 6;
// Blocks each way after which the pattern comes again.
constexpr int kPattern = 64;
constexpr int kBorder = 1;  // cells of a sheet that nothing starts from

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }
int wrapped(int block) { return block - floor_div(block, kPattern) * kPattern; }

// The middles of pieces that share out an exemplar's length among them, half cells.
std::vector<int> middles(int cells, int cell) {
    const double length = std::max(1, cells - 2 * kBorder);
    const int count = std::max(1, int(std::lround(length / kBlock)));
    std::vector<int> at;
    for (int i = 0; i < count; ++i)
        at.push_back(int((0.5 * (cells - length) + (i + 0.5) * length / count) * cell));
    return at;
}

// Share of the block around a spot that land may be taken from.
double usable(const Level& level, const Spot& middle, int cell) {
    const Sheet& sheet = level.sheets[std::size_t(middle.exemplar)];
    const int x0 = middle.x / cell - kBlock / 2, y0 = middle.y / cell - kBlock / 2;
    int count = 0;
    for (int y = std::max(0, y0); y < std::min(sheet.height, y0 + kBlock); ++y)
        for (int x = std::max(0, x0); x < std::min(sheet.width, x0 + kBlock); ++x)
            count += level.types[sheet.index(x, y)] != kNowhere;
    return double(count) / (kBlock * kBlock);
}

// The exemplars cut into pieces of a block's size: each place in one of them.
std::vector<Spot> pieces_of(const Level& level, int cell) {
    std::vector<Spot> all, whole;
    for (int e = 0; e < int(level.sheets.size()); ++e)
        for (const int y : middles(level.sheets[std::size_t(e)].height, cell))
            for (const int x : middles(level.sheets[std::size_t(e)].width, cell))
                all.push_back({e, 0, x, y});
    std::ranges::copy_if(all, std::back_inserter(whole), [&](const Spot& middle) {
        return usable(level, middle, cell) >= 0.5;
    });
    return whole.empty() ? all : whole;
}

// Which piece each block is, far from where the same piece lies already: the same feature
// does not come into view twice before there is no other.
Field<int> pattern_of(int pieces, std::uint64_t seed) {
    constexpr int kFree = -1;
    const int reach =
        std::min(kPattern / 2, 1 + int(std::ceil(std::sqrt(double(pieces)))));
    Field<int> pattern(kPattern, kPattern, kFree);
    std::vector<int> nearest(static_cast<std::size_t>(pieces), 0);
    for (int y = 0; y < kPattern; ++y) {
        for (int x = 0; x < kPattern; ++x) {
            std::ranges::fill(nearest, std::numeric_limits<int>::max());
            for (int dy = -reach; dy <= reach; ++dy) {
                for (int dx = -reach; dx <= reach; ++dx) {
                    const int piece = pattern(wrapped(x + dx), wrapped(y + dy));
                    if (piece == kFree) continue;
                    int& n = nearest[static_cast<std::size_t>(piece)];
                    n = std::min(n, dx * dx + dy * dy);
                }
            }
            const auto order = [&](int piece) {
                return std::pair(nearest[static_cast<std::size_t>(piece)],
                                 hash_of({seed, std::uint64_t(x), std::uint64_t(y),
                                          std::uint64_t(piece)}));
            };
            auto best = order(0);
            int chosen = 0;
            for (int piece = 1; piece < pieces; ++piece)
                if (const auto o = order(piece); o > best) best = o, chosen = piece;
            pattern(x, y) = chosen;
        }
    }
    return pattern;
}

int orientation_of(const Controls& controls, int bx, int by) {
    const std::uint64_t h =
        hash_of({controls.seed, key("start"), key("orientation"),
                 std::uint64_t(std::int64_t{bx}), std::uint64_t(std::int64_t{by})});
    return controls.orientations == 2 ? int(h % 2) * 2
                                      : int(h % std::uint64_t(controls.orientations));
}

}  // namespace

Synthesis started(const Database& database, const Controls& controls,
                  const Window& window) {
    const int top = window.level;
    const Level& level = database.levels[std::size_t(top)];
    const int cell = 2 << top;
    const std::vector<Spot> pieces = pieces_of(level, cell);
    const Field<int> pattern =
        pattern_of(int(pieces.size()), hash_of({controls.seed, key("start")}));

    Synthesis land{window, {window.width, window.height}, {window.width, window.height}};
    for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
            const int x = window.x + column, y = window.y + row;
            const int bx = floor_div(x, kBlock), by = floor_div(y, kBlock);
            Spot middle =
                pieces[static_cast<std::size_t>(pattern(wrapped(bx), wrapped(by)))];
            middle.orientation = orientation_of(controls, bx, by);
            const auto from_middle = [&](int at, int block) {
                return int((at - block * kBlock + 0.5 - 0.5 * kBlock) * cell);
            };
            const Step s =
                kTurns(middle.orientation, from_middle(x, bx), from_middle(y, by));
            land.places(column, row) = place_of(kept_inside(
                middle.moved(s), level.sheets[std::size_t(middle.exemplar)], top));
        }
    }
    return land;
}

}  // namespace cydonia::texture
