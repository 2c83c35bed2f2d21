#include "synth/texture/synthesis/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "field/parallel.h"
#include "field/random.h"
#include "synth/texture/synthesis/pieces.h"

namespace cydonia::texture {
namespace {

constexpr int kAround = Layout::kAround;
constexpr int kBorder = 1;  // cells of the coarsest level that no piece is taken from
constexpr int kSweeps = 6;  // over the plane, which choose each block anew
constexpr int kNear = 3;    // blocks within which the same land counts as repeated
constexpr float kRepeated = 40.0f;  // cost of a piece beside itself
constexpr float kOverused = 1.0f;   // cost of a piece that is used as often as others

int wrapped(int block) { return block & (kAround - 1); }
int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

// Chooses the piece of each block, in several sweeps over the plane: each time the piece
// that costs least there (iterated conditional modes, Besag 1986).
Field<int> arranged(const Pieces& pieces, std::uint64_t seed) {
    const Eigen::Index count = pieces.same.cols();
    Field<int> blocks(kAround, kAround);
    Eigen::VectorXf used = Eigen::VectorXf::Zero(count);
    for (int y = 0; y < kAround; ++y)
        for (int x = 0; x < kAround; ++x) {
            const std::uint64_t h = hash_of({seed, std::uint64_t(x), std::uint64_t(y)});
            blocks(x, y) = int(h % std::uint64_t(count));
            used += pieces.same.col(blocks(x, y));
        }
    const Eigen::VectorXf fair = pieces.same.rowwise().mean() * float(kAround * kAround);
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (int y = 0; y < kAround; ++y)
            for (int x = 0; x < kAround; ++x) {
                const auto piece = [&](int dx, int dy) {
                    return blocks(wrapped(x + dx), wrapped(y + dy));
                };
                used -= pieces.same.col(piece(0, 0));
                Eigen::VectorXf cost = kOverused * used.cwiseQuotient(fair);
                cost += pieces.west.col(piece(1, 0));
                cost += pieces.north.col(piece(0, 1));
                cost += pieces.west.row(piece(-1, 0)).transpose();
                cost += pieces.north.row(piece(0, -1)).transpose();
                for (int dy = -kNear; dy <= kNear; ++dy)
                    for (int dx = -kNear; dx <= kNear; ++dx)
                        if (dx || dy)
                            cost += kRepeated / float(std::max(dx * dx, dy * dy)) *
                                    pieces.same.col(piece(dx, dy));
                Eigen::Index least = 0;
                cost.minCoeff(&least);
                blocks(x, y) = int(least);
                used += pieces.same.col(least);
            }
    return blocks;
}

// The seam along which the heights of two pieces differ least (the minimum error boundary
// cut of Efros and Freeman 2001, section 2.1): for each row, how many cells beyond the
// blocks' edge the second piece begins. `first` and `second` give the land of each at
// (across, along).
template <class Land>
void cut(const Character& character, int side, int reach, Land first, Land second,
         std::int8_t* seam) {
    const int places = 2 * reach + 1;
    std::vector<float> cost(std::size_t(side * places));
    std::vector<std::int8_t> from(cost.size(), 0);
    std::vector<float> differs(std::size_t(2 * reach + 2));
    for (int row = 0; row < side; ++row) {
        for (int c = -reach - 1; c <= reach; ++c) {
            const float step = character.height(character.index(first(c, row))) -
                               character.height(character.index(second(c, row)));
            differs[std::size_t(c + reach + 1)] = step * step;
        }
        for (int p = 0; p < places; ++p) {
            // The cells on both sides of the seam.
            const std::size_t at = std::size_t(row * places + p);
            cost[at] = differs[std::size_t(p)] + differs[std::size_t(p + 1)];
            if (row == 0) continue;
            float least = std::numeric_limits<float>::max();
            for (int q = std::max(0, p - 1); q <= std::min(places - 1, p + 1); ++q) {
                const float before = cost[std::size_t((row - 1) * places + q)];
                if (before < least) least = before, from[at] = std::int8_t(q);
            }
            cost[at] += least;
        }
    }
    const auto last = cost.end() - places;
    int p = int(std::min_element(last, cost.end()) - last);
    for (int row = side - 1; row >= 0; --row) {
        seam[row] = std::int8_t(p - reach);
        p = from[std::size_t(row * places + p)];
    }
}

void cut_seams(Layout& layout, const Character& character) {
    const int side = layout.side, reach = std::min(side / 3, 100);
    layout.west.resize(std::size_t(kAround * kAround * side));
    layout.north.resize(layout.west.size());
    parallel_for(kAround, 1, [&](int by) {
        for (int bx = 0; bx < kAround; ++bx) {
            const int x0 = bx * side, y0 = by * side;
            const std::size_t at = std::size_t((by * kAround + bx) * side);
            const auto land = [&](int block_x, int block_y, bool upright) {
                const int piece = layout.piece(block_x, block_y);
                return [=, &layout](int across, int along) {
                    return layout.land(piece, block_x, block_y, layout.level,
                                       x0 + (upright ? across : along),
                                       y0 + (upright ? along : across));
                };
            };
            cut(character, side, reach, land(bx - 1, by, true), land(bx, by, true),
                &layout.west[at]);
            cut(character, side, reach, land(bx, by - 1, false), land(bx, by, false),
                &layout.north[at]);
        }
    });
}

}  // namespace

Spot Layout::land(int piece, int block_x, int block_y, int at_level, int x, int y) const {
    const Spot& middle = pieces[std::size_t(piece)];
    // The distance from the block's centre in half cells of level 0.
    const int block = side * (2 << level), cell = 2 << at_level;
    const auto from_middle = [&](int i, int b) {
        return i * cell + cell / 2 - b * block - block / 2;
    };
    return middle.moved(
        kTurns(middle.orientation, from_middle(x, block_x), from_middle(y, block_y)));
}

Spot Layout::at(int x, int y) const {
    int bx = floor_div(x, side);
    const int by = floor_div(y, side);
    const auto seam = [&](const std::vector<std::int8_t>& seams, int block_x, int block_y,
                          int along) {
        return seams[std::size_t((wrapped(block_y) * kAround + wrapped(block_x)) * side +
                                 along)];
    };
    const int u = x - bx * side, v = y - by * side;
    if (u < seam(west, bx, by, v))
        --bx;
    else if (u - side >= seam(west, bx + 1, by, v))
        ++bx;
    const int along = std::clamp(x - bx * side, 0, side - 1);
    const int below = v < seam(north, bx, by, along)               ? -1
                      : v - side >= seam(north, bx, by + 1, along) ? 1
                                                                   : 0;
    return land(piece(bx, by + below), bx, by + below, level, x, y);
}

Layout laid_out(const Database& database, int side, int orientations,
                std::uint64_t seed) {
    const int top = int(database.levels.size()) - 1, fine = std::max(0, top - 2);
    const int scale = 1 << (top - fine);
    const Character character(database, fine);
    Pieces pieces = pieces_of(character, side * scale, kBorder * scale, orientations);
    Layout layout{
        std::move(pieces.middles), arranged(pieces, seed), fine, side * scale, {}, {}};
    cut_seams(layout, character);
    return layout;
}

}  // namespace cydonia::texture
