#include "synth/texture/matches.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <span>

#include "field/parallel.h"
#include "field/random.h"
#include "synth/texture/appearance.h"

namespace cydonia::texture {
namespace {

using Float4 = float __attribute__((vector_size(16)));
using Short4 = std::int16_t __attribute__((vector_size(8)));

// The cells of a neighbourhood that are compared: each tells of 5x5 around it.
constexpr std::array<Step, 5> kCompared = {{{0, 0}, {-2, -2}, {2, -2}, {-2, 2}, {2, 2}}};

constexpr float kNone = std::numeric_limits<float>::infinity();

Float4 read(const Appearance& a) {
    Short4 shorts;
    std::memcpy(&shorts, a.data(), sizeof shorts);
    return __builtin_convertvector(shorts, Float4);
}

std::span<const int> turns_of(int orientations) {
    static constexpr int kAll[] = {0, 1, 2, 3, 4, 5, 6, 7};
    static constexpr int kHalf[] = {0, 2};
    if (orientations == 2) return kHalf;
    return std::span(kAll).first(std::size_t(orientations));
}

// A neighbourhood as each way of laying the other down would have to show it.
class Wanted {
  public:
    Wanted(const LevelArrays& level, std::span<const int> turns, int exemplar, int x,
           int y)
        : level_(level) {
        const Sheet& sheet = level.sheets[std::size_t(exemplar)];
        const float height = level.appearance[sheet.index(x, y)][0];
        for (int o : turns) {
            const int back = inverse(o);
            for (std::size_t k = 0; k < kCompared.size(); ++k) {
                const Step s = turned(back, kCompared[k]);
                const Appearance a =
                    turned_appearance(level.appearance[sheet.index(x + s.x, y + s.y)],
                                      back, level.last_sign);
                values_[std::size_t(o)][k] = read(a) - Float4{height, 0, 0, 0};
            }
        }
    }

    float unlikeness(const Match& match) const {
        const Sheet& sheet = level_.sheets[match.exemplar];
        const Appearance* at = &level_.appearance[sheet.index(match.x, match.y)];
        const Float4 height = {float((*at)[0]), 0, 0, 0};
        Float4 squares{}, sum{};
        for (std::size_t k = 0; k < kCompared.size(); ++k) {
            const Step s = kCompared[k];
            const Float4 other = read(at[s.y * sheet.stride + s.x]) - height;
            const Float4 difference = values_[match.orientation][k] - other;
            squares += difference * difference;
            sum += difference;
        }
        // The offset that fits best is the mean difference of heights.
        constexpr float kCells = kCompared.size();
        return (squares[0] + squares[1] + squares[2] + squares[3] -
                sum[0] * sum[0] / kCells) /
               kCells;
    }

  private:
    static constexpr int inverse(int o) { return (o & 4) ? o : (4 - o) & 3; }

    const LevelArrays& level_;
    Float4 values_[8][kCompared.size()];
};

struct Tile {
    int exemplar;
    int x0, y0, x1, y1;
};

// Tiles are scanned alone, each seeing the others as they were before the pass.
std::vector<Tile> tiles_of(const LevelArrays& level) {
    constexpr int kSide = 64;
    std::vector<Tile> tiles;
    for (int e = 0; e < static_cast<int>(level.sheets.size()); ++e) {
        const Sheet& sheet = level.sheets[std::size_t(e)];
        for (int y = 0; y < sheet.height; y += kSide)
            for (int x = 0; x < sheet.width; x += kSide)
                tiles.push_back({e, x, y, std::min(x + kSide, sheet.width),
                                 std::min(y + kSide, sheet.height)});
    }
    return tiles;
}

class Search {
  public:
    Search(const LevelArrays& level, const LevelArrays* coarser, int orientations)
        : level_(level),
          coarser_(coarser),
          turns_(turns_of(orientations)),
          matches_(level.heights.size()),
          scores_(level.heights.size(), kNone) {
        for (const Sheet& sheet : level.sheets) {
            cells_ += sheet.cells();
            cells_before_.push_back(cells_);
        }
    }

    std::uint64_t pairs() const {
        const std::uint64_t cells = cells_;
        return cells * cells * turns_.size();
    }
    void exhaustive(const Tile& tile) {
        each_cell(tile, false, [&](Cell& cell) { try_all(cell); });
    }
    void start(const Tile& tile) {
        each_cell(tile, false, [&](Cell& cell) {
            if (coarser_) try_coarser(cell);
            for (int draw = 0; draw < kFirstDraws; ++draw) try_anywhere(cell, draw);
        });
    }
    void pass(const Tile& tile, int number) {
        const bool backwards = number % 2 == 1;
        each_cell(tile, backwards, [&](Cell& cell) {
            const int back = backwards ? 1 : -1;
            try_beside(cell, {back, 0}, tile);
            try_beside(cell, {0, back}, tile);
            try_around(cell, number);
        });
    }
    void between_passes() { before_ = matches_; }
    std::vector<Match> taken() { return std::move(matches_); }
    float best(int exemplar, int x, int y) const {
        const Wanted wanted(level_, turns_, exemplar, x, y);
        Match match;
        float score = kNone;
        Cell cell{exemplar, x, y, wanted, match, score};
        try_all(cell);
        return score;
    }
    // Where nothing was far enough away (tiny levels) the farthest place.
    void finish(const Tile& tile) {
        each_cell(tile, false, [&](Cell& cell) {
            if (cell.score == kNone) take_farthest(cell);
        });
    }

  private:
    static constexpr int kFirstDraws = 4;

    struct Cell {
        int exemplar, x, y;
        const Wanted& wanted;
        Match& match;
        float& score;
    };

    template <class Visit>
    void each_cell(const Tile& tile, bool backwards, const Visit& visit) {
        const Sheet& sheet = level_.sheets[std::size_t(tile.exemplar)];
        const int width = tile.x1 - tile.x0, count = width * (tile.y1 - tile.y0);
        for (int i = 0; i < count; ++i) {
            const int at = backwards ? count - 1 - i : i;
            const int x = tile.x0 + at % width, y = tile.y0 + at / width;
            const Wanted wanted(level_, turns_, tile.exemplar, x, y);
            const std::size_t index = sheet.index(x, y);
            Cell cell{tile.exemplar, x, y, wanted, matches_[index], scores_[index]};
            visit(cell);
        }
    }

    void consider(Cell& cell, int exemplar, int x, int y, int orientation) const {
        const Sheet& sheet = level_.sheets[std::size_t(exemplar)];
        if (x < 0 || y < 0 || x >= sheet.width || y >= sheet.height) return;
        if (level_.types[sheet.index(x, y)] == kNowhere) return;
        if (exemplar == cell.exemplar) {
            const int dx = x - cell.x, dy = y - cell.y;
            if (dx * dx + dy * dy <= kFarEnough) return;
        }
        const Match match{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                          static_cast<std::uint8_t>(exemplar),
                          static_cast<std::uint8_t>(orientation)};
        const float score = cell.wanted.unlikeness(match);
        if (score >= cell.score) return;
        cell.score = score;
        cell.match = match;
    }

    void try_all(Cell& cell) const {
        for (int e = 0; e < static_cast<int>(level_.sheets.size()); ++e) {
            const Sheet& sheet = level_.sheets[std::size_t(e)];
            for (int y = kBorder; y < sheet.height - kBorder; ++y)
                for (int x = kBorder; x < sheet.width - kBorder; ++x)
                    for (int o : turns_) consider(cell, e, x, y, o);
        }
    }

    // The four cells of a coarse one go on to the four of its match, turned with it.
    void try_coarser(Cell& cell) const {
        const Sheet& sheet = coarser_->sheets[std::size_t(cell.exemplar)];
        const int cx = std::min(cell.x / 2, sheet.width - 1);
        const int cy = std::min(cell.y / 2, sheet.height - 1);
        const Match& m = coarser_->matches[sheet.index(cx, cy)];
        const Step from_middle =  // in halves of a cell
            turned(m.orientation, {2 * (cell.x - 2 * cx) - 1, 2 * (cell.y - 2 * cy) - 1});
        consider(cell, m.exemplar, 2 * m.x + (from_middle.x + 1) / 2,
                 2 * m.y + (from_middle.y + 1) / 2, m.orientation);
    }

    void try_beside(Cell& cell, Step towards, const Tile& tile) const {
        const int x = cell.x + towards.x, y = cell.y + towards.y;
        const Sheet& sheet = level_.sheets[std::size_t(cell.exemplar)];
        if (x < 0 || y < 0 || x >= sheet.width || y >= sheet.height) return;
        const bool here = x >= tile.x0 && y >= tile.y0 && x < tile.x1 && y < tile.y1;
        const Match& m = (here ? matches_ : before_)[sheet.index(x, y)];
        const Step back = turned(m.orientation, {-towards.x, -towards.y});
        consider(cell, m.exemplar, m.x + back.x, m.y + back.y, m.orientation);
    }

    std::uint64_t hash(const Cell& cell, std::uint64_t purpose, int draw) const {
        return hash_of({purpose, std::uint64_t(cell.exemplar), std::uint64_t(cell.x),
                        std::uint64_t(cell.y), std::uint64_t(draw)});
    }
    int drawn_turn(std::uint64_t h) const {
        return turns_[std::size_t(h % turns_.size())];
    }

    void try_anywhere(Cell& cell, int draw) const {
        const std::uint64_t h = hash(cell, key("anywhere"), draw);
        std::uint64_t at = (h >> 8) % cells_;
        std::size_t e = 0;
        while (at >= cells_before_[e]) ++e;
        const Sheet& sheet = level_.sheets[e];
        at -= cells_before_[e] - sheet.cells();
        consider(cell, static_cast<int>(e),
                 static_cast<int>(at % std::uint64_t(sheet.width)),
                 static_cast<int>(at / std::uint64_t(sheet.width)), drawn_turn(h & 255));
    }

    void try_around(Cell& cell, int pass) const {
        int draw = 0;
        for (int radius : {64, 16, 4}) {
            const std::uint64_t h = hash(cell, key("around"), 16 * pass + draw++);
            const Match m = cell.match;
            const int span = 2 * radius + 1;
            const int dx = static_cast<int>((h >> 8 & 0xffff) % span) - radius;
            const int dy = static_cast<int>((h >> 24 & 0xffff) % span) - radius;
            consider(cell, m.exemplar, m.x + dx, m.y + dy, m.orientation);
        }
        try_anywhere(cell, kFirstDraws + pass);
    }

    void take_farthest(Cell& cell) const {
        int farthest = -1;
        for (std::size_t e = 0; e < level_.sheets.size(); ++e) {
            const Sheet& sheet = level_.sheets[e];
            for (int y = 0; y < sheet.height; ++y)
                for (int x = 0; x < sheet.width; ++x) {
                    if (level_.types[sheet.index(x, y)] == kNowhere) continue;
                    const int dx = x - cell.x, dy = y - cell.y;
                    const int distance = dx * dx + dy * dy;
                    if (distance <= farthest) continue;
                    farthest = distance;
                    cell.match = {static_cast<std::uint16_t>(x),
                                  static_cast<std::uint16_t>(y),
                                  static_cast<std::uint8_t>(e), 0};
                }
        }
    }

    const LevelArrays& level_;
    const LevelArrays* coarser_;
    std::span<const int> turns_;
    std::uint64_t cells_ = 0;
    std::vector<std::uint64_t> cells_before_;  // up to and with each exemplar
    std::vector<Match> matches_;
    std::vector<float> scores_;
    std::vector<Match> before_;
};

}  // namespace

float unlikeness(const LevelArrays& level, int exemplar, int x, int y,
                 const Match& match) {
    const int turns[] = {match.orientation};
    return Wanted(level, turns, exemplar, x, y).unlikeness(match);
}

void add_matches(LevelArrays& level, const LevelArrays* coarser, int orientations,
                 Progress& progress, double begin, double end) {
    constexpr int kPasses = 4;
    constexpr std::uint64_t kFewPairs = 100'000'000;
    Search search(level, coarser, orientations);
    const std::vector<Tile> tiles = tiles_of(level);
    const bool few = search.pairs() <= kFewPairs;
    const double work = double(tiles.size()) * (few ? 1 : 1 + kPasses);
    std::atomic<int> done = 0;
    const auto each_tile = [&](const auto& visit) {
        parallel_for(static_cast<int>(tiles.size()), [&](int i) {
            visit(tiles[std::size_t(i)]);
            progress.report(begin + (end - begin) * std::min(1.0, ++done / work));
        });
    };
    if (few) {
        each_tile([&](const Tile& tile) { search.exhaustive(tile); });
    } else {
        each_tile([&](const Tile& tile) { search.start(tile); });
        for (int pass = 0; pass < kPasses; ++pass) {
            search.between_passes();
            each_tile([&](const Tile& tile) { search.pass(tile, pass); });
        }
    }
    each_tile([&](const Tile& tile) { search.finish(tile); });
    level.matches = search.taken();
    for (const Sheet& sheet : level.sheets) fill_guard(sheet, level.matches);
}

float best_unlikeness(const LevelArrays& level, int exemplar, int x, int y,
                      int orientations) {
    return Search(level, nullptr, orientations).best(exemplar, x, y);
}

}  // namespace cydonia::texture
