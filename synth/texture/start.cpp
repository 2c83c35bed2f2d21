#include "synth/texture/start.h"

#include "field/random.h"
#include "synth/texture/pieces.h"

namespace cydonia::texture {
namespace {

// Cells of the coarsest level that start as one piece of land, each way: smaller pieces
// lose landforms, larger ones are copies (bench/realism.sh).
constexpr int kBlock = 4;

bool is_of(TypeSet types, const Level& level, const Spot& spot, int at) {
    if (types == kAnyType) return true;
    const Sheet& sheet = level.sheets[std::size_t(spot.exemplar)];
    const std::uint8_t type =
        level.types[sheet.index(spot.x >> (at + 1), spot.y >> (at + 1))];
    return type < kMostTypes && (types >> type & 1u);
}

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

int orientation_of(const Controls& controls, int bx, int by) {
    const std::uint64_t h =
        hash_of({controls.seed, key("start"), key("orientation"),
                 std::uint64_t(std::int64_t{bx}), std::uint64_t(std::int64_t{by})});
    return controls.orientations == 2 ? int(h % 2) * 2
                                      : int(h % std::uint64_t(controls.orientations));
}

}  // namespace

Synthesis started(const Database& database, const Controls& controls,
                  const Field<TypeSet>& types, const Window& window) {
    const int top = window.level;
    const Level& level = database.levels[std::size_t(top)];
    const int cell = 2 << top;
    const std::vector<Piece> pieces = pieces_of(database, kBlock);
    const Field<int> blocks =
        arranged(pieces, hash_of({controls.seed, key("start"), key("pieces")}));

    Synthesis land{window, {window.width, window.height}, {window.width, window.height}};
    for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
            const int x = window.x + column, y = window.y + row;
            const int bx = floor_div(x, kBlock), by = floor_div(y, kBlock);
            const int orientation = orientation_of(controls, bx, by);
            const auto from_middle = [&](int at, int block) {
                return int((at - block * kBlock + 0.5 - 0.5 * kBlock) * cell);
            };
            const Step s = kTurns(orientation, from_middle(x, bx), from_middle(y, by));
            const auto land_of = [&](int piece) {
                Spot spot = pieces[static_cast<std::size_t>(piece)].middle;
                spot.orientation = orientation;
                return kept_inside(spot.moved(s),
                                   level.sheets[std::size_t(spot.exemplar)], top);
            };
            const int count = int(pieces.size());
            const int laid = blocks(bx & (kArrangement - 1), by & (kArrangement - 1));
            Spot spot = land_of(laid);
            const TypeSet asked = types.empty() ? kAnyType : types(column, row);
            for (int k = 1; k < count && !is_of(asked, level, spot, top); ++k)
                spot = land_of((laid + k) % count);
            land.places(column, row) = place_of(spot);
        }
    }
    return land;
}

}  // namespace cydonia::texture
