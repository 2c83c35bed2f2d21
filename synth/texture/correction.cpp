#include "synth/texture/correction.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "field/parallel.h"
#include "field/random.h"
#include "synth/texture/appearance_read.h"
#include "synth/texture/places.h"

namespace cydonia::texture {
namespace {

// The four diagonal neighbours of eq. 4 and 6.
constexpr Step kDiagonals[4] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
// Eq. 3's steps, a cell's own place first: it keeps ties.
constexpr Step kNeighbours[9] = {{0, 0}, {-1, -1}, {0, -1}, {1, -1}, {-1, 0},
                                 {1, 0}, {-1, 1},  {0, 1},  {1, 1}};

// How much a height offset costs beside the four neighbours, on coarse levels: free it
// wanders over hundreds of metres, everywhere it holds seams (notes.md, trial 3).
constexpr float kOffsetPrice = 0.2f;
constexpr int kFinestPriced = 3;

template <bool kSnapped>
class Pass {
  public:
    Pass(Synthesis& land, const Database& database, const Controls& controls)
        : land_(land),
          level_(database.levels[std::size_t(land.window.level)]),
          read_(level_, land.window.level),
          cell_(2 << land.window.level),
          width_(land.window.width),
          kappa_(static_cast<float>(controls.kappa)),
          price_(land.window.level - controls.finest >= kFinestPriced ? kOffsetPrice
                                                                      : 0.0f) {}

    void cell(int x, int y) const {
        const std::size_t at = land_.places.index(x, y);
        if (kSnapped && settled(at)) return;
        Best best;
        const Around around = neighbourhood(at);
        Tried tried;
        for (int i = 0; i < 9; ++i) {
            const Step d = kNeighbours[i];
            const Spot spot = spot_of(land_.places[at + offset(d)]);
            const Step back = kTurns(spot.orientation, -d.x * cell_, -d.y * cell_);
            consider(spot.moved(back), 1.0f, around, tried, best);
        }
        for (int i = 0; i < 9; ++i) {
            const Step d = kNeighbours[i];
            const Spot spot = match_of(spot_of(land_.places[at + offset(d)]));
            const Step back = kTurns(spot.orientation, -d.x * cell_, -d.y * cell_);
            consider(spot.moved(back), kappa_, around, tried, best);
        }
        if (best.score == std::numeric_limits<float>::max()) return;
        land_.places[at] = place_of(best.spot);
        land_.offsets[at] = best.offset;
    }

  private:
    // N_S, three times eq. 6, and where its heights would like the offset to be.
    struct Around {
        Int4 corners[4];
    };
    struct Tried {
        int count = 0;
        std::array<Place, 18> places;
    };
    struct Best {
        float score = std::numeric_limits<float>::max();
        Spot spot;
        std::int32_t offset = 0;
    };

    std::ptrdiff_t offset(Step s) const { return std::ptrdiff_t(s.y) * width_ + s.x; }

    // Whether all that the score looks at continues this cell's land at its height: then
    // the score is 0 and cannot be beaten.
    bool settled(std::size_t at) const {
        const Place own = land_.places[at];
        const std::int32_t height = land_.offsets[at];
        const Step e = kTurns.east[own.orientation()],
                   s = kTurns.south[own.orientation()];
        bool same = true;
        const auto continues = [&](int dx, int dy) {
            const std::size_t there = at + offset({dx, dy});
            const Place p = land_.places[there];
            same &= p.x == own.x + std::uint32_t((e.x * dx + s.x * dy) * cell_);
            same &= p.y == own.y + std::uint32_t((e.y * dx + s.y * dy) * cell_);
            same &= land_.offsets[there] == height;
        };
        for (const Step d : kDiagonals) {
            continues(d.x, d.y);
            continues(2 * d.x, d.y);
            continues(d.x, 2 * d.y);
            if (!same) return false;
        }
        return true;
    }

    // g of eq. 5: the appearance at one cell as its neighbour at -v sees it.
    Int4 seen(std::size_t there, Step v) const {
        const Spot spot = spot_of(land_.places[there]);
        const Step back = kTurns(spot.orientation, -v.x * cell_, -v.y * cell_);
        Int4 a = read_.template at<kSnapped>(spot.moved(back));
        a[0] += land_.offsets[there];
        return a;
    }

    Around neighbourhood(std::size_t at) const {
        Around around;
        for (int i = 0; i < 4; ++i) {
            const Step d = kDiagonals[i];
            around.corners[i] = seen(at + offset(d), {0, 0}) +
                                seen(at + offset({2 * d.x, d.y}), {d.x, 0}) +
                                seen(at + offset({d.x, 2 * d.y}), {0, d.y});
        }
        return around;
    }

    // C_2 at the place's cell; it lies in its cell as the place does in its own.
    Spot match_of(const Spot& spot) const {
        const int level = land_.window.level;
        const Sheet& sheet = level_.sheets[std::size_t(spot.exemplar)];
        const int i = spot.x >> (level + 1), j = spot.y >> (level + 1);
        const Match m = level_.matches[sheet.index(i, j)];
        const Step within = kTurns(m.orientation, spot.x - (i * cell_ + cell_ / 2),
                                   spot.y - (j * cell_ + cell_ / 2));
        return {m.exemplar, kTurns.composed[spot.orientation][m.orientation],
                m.x * cell_ + cell_ / 2 + within.x, m.y * cell_ + cell_ / 2 + within.y};
    }

    bool land_may_come_from(const Spot& spot) const {
        const Sheet& sheet = level_.sheets[std::size_t(spot.exemplar)];
        const int i = spot.x >> (land_.window.level + 1);
        const int j = spot.y >> (land_.window.level + 1);
        return unsigned(i) < unsigned(sheet.width) &&
               unsigned(j) < unsigned(sheet.height) &&
               level_.types[sheet.index(i, j)] != kNowhere;
    }

    void consider(const Spot& spot, float kappa, const Around& around, Tried& tried,
                  Best& best) const {
        if (!land_may_come_from(spot)) return;
        const Place place = place_of(spot);
        for (int i = 0; i < tried.count; ++i)
            if (tried.places[std::size_t(i)] == place) return;
        tried.places[std::size_t(tried.count++)] = place;
        score(spot, kappa, around, best);
    }

    // Eq. 7 with h in closed form, in thirds of the database's unit.
    void score(const Spot& spot, float kappa, const Around& around, Best& best) const {
        Float4 d[4];
        for (int i = 0; i < 4; ++i) {
            const Step s = kTurns(spot.orientation, kDiagonals[i].x * cell_,
                                  kDiagonals[i].y * cell_);
            d[i] = __builtin_convertvector(
                around.corners[i] - 3 * read_.template at<kSnapped>(spot.moved(s)),
                Float4);
        }
        const float mean = ((d[0][0] + d[2][0]) + (d[1][0] + d[3][0])) * 0.25f;
        const Float4 level{mean, 0.0f, 0.0f, 0.0f};
        for (Float4& corner : d) corner -= level;
        const Float4 squares = (d[0] * d[0] + d[2] * d[2]) + (d[1] * d[1] + d[3] * d[3]);
        float sum = (squares[0] + squares[2]) + (squares[1] + squares[3]);
        sum += 4.0f * price_ / (4.0f + price_) * mean * mean;
        sum *= kappa;
        if (sum >= best.score) return;
        best = {sum, spot,
                static_cast<std::int32_t>(
                    std::lrintf(4.0f * mean / (4.0f + price_) * (1.0f / 3.0f)))};
    }

    Synthesis& land_;
    const Level& level_;
    const AppearanceReader read_;
    const int cell_, width_;
    const float kappa_, price_;
};

template <bool kSnapped>
void correct_in_place(Synthesis& land, const Database& database,
                      const Controls& controls) {
    const Window& w = land.window;
    const Pass<kSnapped> pass(land, database, controls);
    // Cells of one parity look at none of their own, so that they change in place. Parity
    // is that of the plane.
    for (int sub = 0; sub < 4; ++sub) {
        const int x0 = 2 + ((w.x + 2 + (sub & 1)) & 1);
        const int y0 = 2 + ((w.y + 2 + (sub >> 1)) & 1);
        const int rows = (w.height - 2 - y0 + 1) / 2;
        parallel_for(std::max(0, rows), 4, [&](int row) {
            for (int x = x0; x < w.width - 2; x += 2) pass.cell(x, y0 + 2 * row);
        });
    }
}

}  // namespace

void correct(Synthesis& land, const Database& database, const Controls& controls,
             const Guidance& guidance, int pass) {
    static_cast<void>(guidance);
    static_cast<void>(pass);
    if (is_snapped(land.window.level, controls))
        correct_in_place<true>(land, database, controls);
    else
        correct_in_place<false>(land, database, controls);
}

}  // namespace cydonia::texture
