#include "synth/texture/synthesis/start.h"

#include <algorithm>
#include <limits>

#include "field/random.h"
#include "synth/texture/synthesis/layout.h"

namespace cydonia::texture {
namespace {

// The side of the pieces from which a synthesis starts, in cells of the coarsest level.
// Smaller pieces lose landforms and drainage, larger ones leave too few to choose from
// (bench/real-or-not.sh).
constexpr int kLeastBlock = 4, kMostBlock = 8;
constexpr double kShare = 0.4;  // of the smallest exemplar's shorter side
// Pieces that follow each other in the list are nearly the same land. Steps of a prime
// larger than their number visit all of them.
constexpr int kStride = 1009;

bool is_of(TypeSet types, const Level& level, const Spot& spot, int at) {
    if (types == kAnyType) return true;
    const Sheet& sheet = level.sheets[std::size_t(spot.exemplar)];
    const std::uint8_t type =
        level.types[sheet.index(spot.x >> (at + 1), spot.y >> (at + 1))];
    return type < kMostTypes && (types >> type & 1u);
}

int block_of(const Level& level) {
    int shorter = std::numeric_limits<int>::max();
    for (const Sheet& sheet : level.sheets)
        shorter = std::min({shorter, sheet.width, sheet.height});
    return std::clamp(int(kShare * shorter), kLeastBlock, kMostBlock);
}

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

}  // namespace

Layout start_of(const Database& database, const Controls& controls) {
    return laid_out(database, block_of(database.levels.back()), controls.orientations,
                    hash_of({controls.seed, key("start"), key("layout")}));
}

Synthesis started(const Database& database, const Layout& layout,
                  const Field<TypeSet>& types, const Window& window) {
    const int top = window.level;
    const Level& level = database.levels[std::size_t(top)];
    const int count = int(layout.pieces.size());
    const int block = layout.side >> (top - layout.level);
    Synthesis land{window, {window.width, window.height}, {window.width, window.height}};
    for (int row = 0; row < window.height; ++row)
        for (int column = 0; column < window.width; ++column) {
            const int x = window.x + column, y = window.y + row;
            const int bx = floor_div(x, block), by = floor_div(y, block);
            const auto land_of = [&](int piece) {
                const Spot spot = layout.land(piece, bx, by, top, x, y);
                return kept_inside(spot, level.sheets[std::size_t(spot.exemplar)], top);
            };
            const int laid = layout.piece(bx, by);
            Spot spot = land_of(laid);
            const TypeSet asked = types.empty() ? kAnyType : types(column, row);
            for (int k = 1; k < count && !is_of(asked, level, spot, top); ++k)
                spot = land_of(int((laid + std::int64_t{k} * kStride) % count));
            land.origins(column, row) = origin_of(spot);
        }
    return land;
}

void cut_out(Synthesis& land, const Database& database, const Layout& layout,
             const Field<TypeSet>& types) {
    const Window& window = land.window;
    const Level& level = database.levels[std::size_t(window.level)];
    for (int row = 0; row < window.height; ++row)
        for (int column = 0; column < window.width; ++column) {
            if (!types.empty() && types(column, row) != kAnyType) continue;
            const Spot spot = layout.at(window.x + column, window.y + row);
            land.origins(column, row) = origin_of(kept_inside(
                spot, level.sheets[std::size_t(spot.exemplar)], window.level));
        }
}

}  // namespace cydonia::texture
