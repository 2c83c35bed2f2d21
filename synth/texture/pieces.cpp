#include "synth/texture/pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "field/random.h"

namespace cydonia::texture {
namespace {

constexpr int kBorder = 1;  // cells of a sheet that nothing starts from

// The middles of pieces that share out an exemplar's length among them, half cells.
std::vector<int> middles(int cells, int side, int cell) {
    const double length = std::max(1, cells - 2 * kBorder);
    const int count = std::max(1, int(std::lround(length / side)));
    std::vector<int> at;
    for (int i = 0; i < count; ++i)
        at.push_back(int((0.5 * (cells - length) + (i + 0.5) * length / count) * cell));
    return at;
}

// Sums over a piece's land at one level.
struct Sums {
    int cells = 0, land = 0;
    double heights = 0.0, steps = 0.0;
};

Sums sums_of(const Level& level, int at, const Spot& middle, int side) {
    const Sheet& sheet = level.sheets[std::size_t(middle.exemplar)];
    const int x0 = (middle.x >> (at + 1)) - side / 2;
    const int y0 = (middle.y >> (at + 1)) - side / 2;
    Sums sums{.cells = side * side};
    for (int y = std::max(0, y0); y < std::min(sheet.height, y0 + side); ++y)
        for (int x = std::max(0, x0); x < std::min(sheet.width, x0 + side); ++x) {
            const std::size_t i = sheet.index(x, y);
            if (level.types[i] == kNowhere) continue;
            const auto step = [&](std::size_t j) {
                return std::abs(double(level.heights[j]) - level.heights[i]);
            };
            ++sums.land;
            sums.heights += level.heights[i];
            sums.steps += step(i + 1) + step(i + std::size_t(sheet.stride));
        }
    return sums;
}

void standardise(std::vector<Piece>& pieces, double Piece::*what) {
    const double count = static_cast<double>(pieces.size());
    double mean = 0.0, variance = 0.0;
    for (const Piece& piece : pieces) mean += piece.*what / count;
    for (const Piece& piece : pieces)
        variance += (piece.*what - mean) * (piece.*what - mean) / count;
    for (Piece& piece : pieces)
        piece.*what = variance > 0.0 ? (piece.*what - mean) / std::sqrt(variance) : 0.0;
}

int wrapped(int block) { return block & (kArrangement - 1); }

}  // namespace

std::vector<Piece> pieces_of(const Database& database, int side) {
    // What a piece is like shows on any level that is not coarse.
    const int top = int(database.levels.size()) - 1, fine = std::min(top, 2);
    const Level &coarse = database.levels[std::size_t(top)],
                &detailed = database.levels[std::size_t(fine)];
    const int cell = 2 << top;
    std::vector<Piece> all, whole;
    for (int e = 0; e < int(coarse.sheets.size()); ++e) {
        const Sheet& sheet = coarse.sheets[std::size_t(e)];
        for (const int y : middles(sheet.height, side, cell))
            for (const int x : middles(sheet.width, side, cell)) {
                const Spot middle{e, 0, x, y};
                const Sums sums = sums_of(detailed, fine, middle, side << (top - fine));
                const double land = std::max(1, sums.land);
                all.push_back({middle, sums.heights / land,
                               std::log(sums.steps / land + database.unit)});
                if (2 * sums.land >= sums.cells) whole.push_back(all.back());
            }
    }
    std::vector<Piece>& pieces = whole.empty() ? all : whole;
    standardise(pieces, &Piece::height);
    standardise(pieces, &Piece::roughness);
    return pieces;
}

Field<int> arranged(const std::vector<Piece>& pieces, std::uint64_t seed) {
    constexpr int kFree = -1;
    constexpr int kAround = 3;  // blocks within which a piece is to differ
    constexpr int kMostCompared = 16;
    const int count = int(pieces.size());
    const int reach =
        std::min(kArrangement / 2 - 1, 1 + int(std::ceil(std::sqrt(double(count)))));
    Field<int> blocks(kArrangement, kArrangement, kFree);

    std::vector<int> nearest(static_cast<std::size_t>(count));
    const auto find_nearest = [&](int x, int y) {
        std::ranges::fill(nearest, std::numeric_limits<int>::max());
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                const int there = blocks(wrapped(x + dx), wrapped(y + dy));
                if (there == kFree) continue;
                int& least = nearest[static_cast<std::size_t>(there)];
                least = std::min(least, dx * dx + dy * dy);
            }
    };
    const auto likeness = [&](const Piece& piece, int x, int y) {
        double sum = 0.0;
        for (int dy = -kAround; dy <= kAround; ++dy)
            for (int dx = -kAround; dx <= kAround; ++dx) {
                const int there = blocks(wrapped(x + dx), wrapped(y + dy));
                if (there == kFree) continue;
                const Piece& other = pieces[static_cast<std::size_t>(there)];
                const double height = piece.height - other.height;
                const double roughness = piece.roughness - other.roughness;
                sum += std::exp(-2.0 * (height * height + roughness * roughness)) /
                       (dx * dx + dy * dy);
            }
        return sum;
    };

    for (int y = 0; y < kArrangement; ++y)
        for (int x = 0; x < kArrangement; ++x) {
            find_nearest(x, y);
            const int furthest = *std::ranges::max_element(nearest);
            const std::uint64_t h = hash_of({seed, std::uint64_t(x), std::uint64_t(y)});
            const int first = int(h % std::uint64_t(count));
            double least = std::numeric_limits<double>::max();
            int chosen = 0;
            for (int k = 0, compared = 0; k < count && compared < kMostCompared; ++k) {
                const int i = (first + k) % count;
                if (nearest[static_cast<std::size_t>(i)] < furthest) continue;
                ++compared;
                const double like = likeness(pieces[static_cast<std::size_t>(i)], x, y);
                if (like < least) least = like, chosen = i;
            }
            blocks(x, y) = chosen;
        }
    return blocks;
}

}  // namespace cydonia::texture
