#include "synth/texture/synthesis/correction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <vector>

#include "field/parallel.h"
#include "field/random.h"
#include "synth/texture/constraints/pull.h"
#include "synth/texture/constraints/residual.h"
#include "synth/texture/database/pyramid.h"
#include "synth/texture/synthesis/appearance_read.h"
#include "synth/texture/synthesis/height_read.h"
#include "synth/texture/synthesis/origins.h"

namespace cydonia::texture {
namespace {

// The four diagonal neighbours of eq. 4 and 6.
constexpr Step kDiagonals[4] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
// The steps of eq. 3. A cell's own is the first, so that it wins ties.
constexpr Step kNeighbours[9] = {{0, 0}, {-1, -1}, {0, -1}, {1, -1}, {-1, 0},
                                 {1, 0}, {-1, 1},  {0, 1},  {1, 1}};

// The weight of a height offset beside the four neighbours, from level 0 on. Held on fine
// levels it keeps seams, free on coarse ones it evens out the relief (docs/papers.md,
// Gain 2015, trial 3; bench/realism.sh).
constexpr float kOffsetPrices[] = {0.0f, 0.0f, 0.0f, 0.5f, 2.0f, 4.0f};
float offset_price(int level) {
    return kOffsetPrices[std::min<std::size_t>(std::size_t(level),
                                               std::size(kOffsetPrices) - 1)];
}

// Where no type is requested, land is corrected from this level on. On coarser levels
// blocks stay as they were laid out (synth/texture/synthesis/pieces.h), because a
// correction would spread some pieces over others and leave copies of large parts of an
// exemplar, some of them twice (bench/realism.sh, columns used and repeated). The matches
// of this level would do the same.
constexpr int kCoarsestCorrected = 4;

constexpr int kSeedsOfType = 9;
constexpr int kMostCandidates = 19;

bool voids_in(const Level& level, const Sheet& sheet, int border) {
    for (int y = border; y < sheet.height - border; ++y)
        if (std::memchr(&level.types[sheet.index(border, y)], kNowhere,
                        std::size_t(std::max(0, sheet.width - 2 * border))))
            return true;
    return false;
}

template <bool kSnapped>
class Pass {
  public:
    Pass(Synthesis& land, const Database& database, const Controls& controls,
         const CellGuidance& guidance, const PinnedRegion& pinned, int pass)
        : land_(land),
          guidance_(guidance),
          pinned_(pinned),
          controls_(controls),
          unit_(static_cast<float>(database.unit)),
          seed_(hash_of({controls.seed, key("seeds"), std::uint64_t(pass)})),
          level_(database.levels[std::size_t(land.window.level)]),
          read_(level_, land.window.level),
          cell_(2 << land.window.level),
          width_(land.window.width),
          kappa_(static_cast<float>(controls.kappa)),
          price_(offset_price(land.window.level)),
          border_(border_of(land.window.level)) {
        for (const Sheet& sheet : level_.sheets)
            has_voids_.push_back(voids_in(level_, sheet, border_));
    }

    void cell(int x, int y) const {
        const std::size_t at = land_.origins.index(x, y);
        const float weight = pinned_.weights.empty() ? 1.0f : pinned_.weights[at];
        if (weight == 0.0f) return keep(at);
        if (kSnapped && settled(at, weight)) return;

        const TypeSet types = guidance_.types.empty() ? kAnyType : guidance_.types[at];
        if (land_.window.level > kCoarsestCorrected && types == kAnyType &&
            weight == 1.0f)
            return;
        Candidates candidates;
        gather(at, types, candidates);
        Contest contest(neighbourhood(at), price_at(at));
        if (weight < 1.0f && may_be_used(spot_of(pinned_.origins[at]), types))
            score_pinned(at, weight, contest);
        for (int i = 0; i < candidates.count; ++i) {
            const Candidate& candidate = candidates.all[std::size_t(i)];
            score(candidate.around, candidate.kappa, contest);
        }
        if (contest.nothing() && types != kAnyType) seed(x, y, types, contest);
        if (contest.nothing()) return;
        land_.origins[at] = origin_of(contest.spot);
        land_.offsets[at] = contest.offset;
        if (!guidance_.pulls.empty()) pull(at, contest.spot);
    }

  private:
    // N_S of eq. 6, times three.
    struct Around {
        Int4 corners[4];
    };
    using Reading = AppearanceReader::Around;
    // A member of Q, eq. 3, and the factor of its score. No two have the same origin.
    struct Candidate {
        Origin place;
        Reading around;
        float kappa;
    };
    struct Candidates {
        int count = 0;
        std::array<Candidate, kMostCandidates> all;
        Candidates() {}
    };
    struct Contest {
        Contest(const Around& a, float p) : around(a), price(p) {}
        Around around;
        float price;
        float score = std::numeric_limits<float>::max();
        Spot spot;
        std::int32_t offset = 0;

        bool nothing() const { return score == std::numeric_limits<float>::max(); }
    };

    std::ptrdiff_t offset(Step s) const { return std::ptrdiff_t(s.y) * width_ + s.x; }

    // Whether all cells that the score looks at continue this cell's land. Then no
    // candidate fits better, and only the height is solved for.
    bool settled(std::size_t at, float weight) const {
        const Origin own = land_.origins[at];
        const Step e = kTurns.east[own.orientation()],
                   s = kTurns.south[own.orientation()];
        bool same = true;
        std::int64_t heights = 0;
        const auto look = [&](int dx, int dy) {
            const std::size_t there = at + offset({dx, dy});
            const Origin p = land_.origins[there];
            same &= p.x == own.x + std::uint32_t((e.x * dx + s.x * dy) * cell_);
            same &= p.y == own.y + std::uint32_t((e.y * dx + s.y * dy) * cell_);
            heights += land_.offsets[there];
        };
        for (const Step d : kDiagonals) {
            look(d.x, d.y);
            look(2 * d.x, d.y);
            look(d.x, 2 * d.y);
            if (!same) return false;
        }
        const bool kept = weight < 1.0f && pinned_.origins[at] == own;
        land_.offsets[at] = kept ? pinned_.offsets[at]
                                 : static_cast<std::int32_t>(std::lrintf(
                                       static_cast<float>(heights) * (1.0f / 12.0f)));
        return true;
    }

    // g of eq. 5: the appearance at a cell as its neighbour at -v sees it.
    Int4 seen(std::size_t there, Step v) const {
        const Reading around =
            read_.template around<kSnapped>(spot_of(land_.origins[there]));
        Int4 a = read_.template at<kSnapped>(around, -v.x, -v.y);
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

    const Match* match_at(const Spot& spot) const {
        const int level = land_.window.level;
        const Sheet& sheet = level_.sheets[std::size_t(spot.exemplar)];
        return &level_.matches[sheet.index(spot.x >> (level + 1), spot.y >> (level + 1))];
    }
    // C_2 of a position's cell, with the same offset from its cell's centre.
    Spot match_of(const Spot& spot) const {
        const Match m = *match_at(spot);
        const int o = kTurns.composed[spot.orientation][m.orientation];
        const int x = m.x * cell_ + cell_ / 2, y = m.y * cell_ + cell_ / 2;
        if (kSnapped) return {m.exemplar, o, x, y};
        // This works because a cell's width is a power of two.
        const Step within = kTurns(m.orientation, (spot.x & (cell_ - 1)) - cell_ / 2,
                                   (spot.y & (cell_ - 1)) - cell_ / 2);
        return {m.exemplar, o, x + within.x, y + within.y};
    }

    // A neighbour's land continued to this cell.
    Spot seen_from(const Spot& spot, Step d) const {
        return spot.moved(kTurns(spot.orientation, -d.x * cell_, -d.y * cell_));
    }

    bool may_be_used(const Spot& spot, TypeSet types) const {
        const Sheet& sheet = level_.sheets[std::size_t(spot.exemplar)];
        const int i = spot.x >> (land_.window.level + 1);
        const int j = spot.y >> (land_.window.level + 1);
        if (unsigned(i - border_) >= unsigned(sheet.width - 2 * border_) ||
            unsigned(j - border_) >= unsigned(sheet.height - 2 * border_))
            return false;
        if (types == kAnyType && !has_voids_[std::size_t(spot.exemplar)]) return true;
        const std::uint8_t type = level_.types[sheet.index(i, j)];
        if (type == kNowhere) return false;
        return types == kAnyType || (type < kMostTypes && (types >> type & 1u));
    }

    // Whether a match has another type than the cell that it is a match of. On the two
    // finest levels, where types are no longer requested, such matches alone would mix a
    // tenth of the land that the coarser levels sorted.
    bool changes_type(const Spot& spot, const Spot& match) const {
        if (!kSnapped || !guidance_.typed) return false;
        const auto type = [&](const Spot& s) {
            const Sheet& sheet = level_.sheets[std::size_t(s.exemplar)];
            const int x = std::clamp(s.x >> (land_.window.level + 1), 0, sheet.width - 1);
            const int y =
                std::clamp(s.y >> (land_.window.level + 1), 0, sheet.height - 1);
            return level_.types[sheet.index(x, y)];
        };
        return type(spot) != type(match);
    }

    void gather(std::size_t at, TypeSet types, Candidates& candidates) const {
        Spot around[9];
        for (int i = 0; i < 9; ++i) {
            around[i] = spot_of(land_.origins[at + offset(kNeighbours[i])]);
            if (kSnapped) __builtin_prefetch(match_at(around[i]));
        }
        for (int i = 0; i < 9; ++i)
            add(seen_from(around[i], kNeighbours[i]), 1.0f, types, candidates);
        if (land_.window.level >= kCoarsestCorrected && types == kAnyType) return;
        for (int i = 0; i < 9; ++i) {
            const Spot match = match_of(around[i]);
            if (changes_type(around[i], match)) continue;
            add(seen_from(match, kNeighbours[i]), kappa_, types, candidates);
        }
    }

    // Candidates are scored later, so that the prefetched memory can arrive first.
    void add(const Spot& spot, float kappa, TypeSet types, Candidates& candidates) const {
        if (!may_be_used(spot, types)) return;
        const Origin place = origin_of(spot);
        for (int i = 0; i < candidates.count; ++i)
            if (candidates.all[std::size_t(i)].place == place) return;
        Candidate& next = candidates.all[std::size_t(candidates.count++)];
        next = {place, read_.template around<kSnapped>(spot), kappa};
        read_.fetch(next.around);
    }

    // How a candidate's neighbourhood differs from N_S: the offset in height, and the
    // rest of eq. 7 without it. In thirds of the database's unit.
    struct Difference {
        float height, rest;
    };
    // Stops half way where the rest already reaches `enough`.
    Difference difference(const Reading& place, const Around& around,
                          float enough) const {
        Float4 d[4];
        const auto corner = [&](int i) {
            const Step s = kDiagonals[i];
            d[i] = __builtin_convertvector(
                around.corners[i] - 3 * read_.template at<kSnapped>(place, s.x, s.y),
                Float4);
        };
        corner(0);
        corner(1);
        const Float4 half = d[0] * d[0] + d[1] * d[1];
        const float least = (half[1] + half[2]) + half[3];
        if (least >= enough) return {0.0f, least};
        corner(2);
        corner(3);
        const float mean = ((d[0][0] + d[2][0]) + (d[1][0] + d[3][0])) * 0.25f;
        const Float4 level{mean, 0.0f, 0.0f, 0.0f};
        for (Float4& of : d) of -= level;
        const Float4 squares = (d[0] * d[0] + d[2] * d[2]) + (d[1] * d[1] + d[3] * d[3]);
        return {mean, (squares[0] + squares[2]) + (squares[1] + squares[3])};
    }

    // Eq. 7, with h solved in closed form.
    void score(const Reading& place, float kappa, Contest& contest) const {
        const auto [mean, rest] =
            difference(place, contest.around, contest.score / kappa);
        const float price = contest.price;
        const float sum = kappa * (rest + 4.0f * price / (4.0f + price) * mean * mean);
        if (sum >= contest.score) return;
        contest.score = sum;
        contest.spot = place.spot;
        contest.offset = static_cast<std::int32_t>(
            std::lrintf(4.0f / (4.0f + price) * mean * (1.0f / 3.0f)));
    }

    // The score of pinned land, at its own height; otherwise a small change of height
    // anywhere would move all land slightly.
    void score_pinned(std::size_t at, float weight, Contest& contest) const {
        const Spot spot = spot_of(pinned_.origins[at]);
        const auto [mean, rest] =
            difference(read_.template around<kSnapped>(spot), contest.around,
                       std::numeric_limits<float>::infinity());
        const float offset = 3.0f * static_cast<float>(pinned_.offsets[at]);
        contest.score = weight * (rest + 4.0f * (mean - offset) * (mean - offset) +
                                  contest.price * offset * offset);
        contest.spot = spot;
        contest.offset = pinned_.offsets[at];
    }

    // Where constraints set the height, an offset costs nothing.
    float price_at(std::size_t at) const {
        const bool held = !guidance_.pulls.empty() && guidance_.pulls[at].reach > 0.0f;
        return held ? 0.0f : price_;
    }

    void keep(std::size_t at) const {
        land_.origins[at] = pinned_.origins[at];
        land_.offsets[at] = pinned_.offsets[at];
    }

    // Section 5.2: where no candidate has a requested type, tries nine seeds of each such
    // type.
    void seed(int x, int y, TypeSet types, Contest& contest) const {
        for (int t = 0; t < kMostTypes; ++t) {
            if (!(types >> t & 1u)) continue;
            const auto& seeds = level_.seeds[std::size_t(t)];
            for (int i = 0; i < kSeedsOfType && !seeds.empty(); ++i) {
                const std::uint64_t h =
                    hash_of({seed_, std::uint64_t(land_.window.level),
                             std::uint64_t(std::int64_t{land_.window.x + x}),
                             std::uint64_t(std::int64_t{land_.window.y + y}),
                             std::uint64_t(t * kSeedsOfType + i)});
                const std::uint64_t seed = seeds[h % seeds.size()];
                constexpr std::uint64_t kLow = (1u << 24) - 1;
                const Spot spot{int(seed >> 48), 0, int(seed & kLow) * cell_ + cell_ / 2,
                                int(seed >> 24 & kLow) * cell_ + cell_ / 2};
                score(read_.template around<kSnapped>(spot), 1.0f, contest);
            }
        }
    }

    // Eq. 9: moves the height towards what points and curves ask for.
    void pull(std::size_t at, const Spot& spot) const {
        const Pull& wish = guidance_.pulls[at];
        if (!(wish.reach > 0.0f)) return;
        const float height = height_at(level_, land_.window.level, spot) +
                             unit_ * float(land_.offsets[at]);
        const float wanted = blended(height, wish, controls_.stiffness, controls_.pull);
        land_.offsets[at] +=
            static_cast<std::int32_t>(std::lrintf((wanted - height) / unit_));
    }

    Synthesis& land_;
    const CellGuidance& guidance_;
    const PinnedRegion& pinned_;
    const Controls& controls_;
    const float unit_;
    const std::uint64_t seed_;
    const Level& level_;
    const AppearanceReader read_;
    const int cell_, width_;
    const float kappa_, price_;
    const int border_;
    std::vector<char> has_voids_;  // of each exemplar
};

template <bool kSnapped>
void correct_in_place(const Window& w, const Pass<kSnapped>& pass) {
    // Cells of one parity do not look at one another, so they can be changed in place.
    // Parity is that of the cell's position on the plane, not in the window.
    for (int sub = 0; sub < 4; ++sub) {
        const int x0 = 2 + ((w.x + (sub & 1)) & 1);
        const int y0 = 2 + ((w.y + (sub >> 1)) & 1);
        const int rows = (w.height - 2 - y0 + 1) / 2;
        parallel_for(std::max(0, rows), 4, [&](int row) {
            for (int x = x0; x < w.width - 2; x += 2) pass.cell(x, y0 + 2 * row);
        });
    }
}

}  // namespace

void correct(Synthesis& land, const Database& database, const Controls& controls,
             const CellGuidance& guidance, const PinnedRegion& pinned, int pass) {
    const CellGuidance of_finest{.typed = guidance.typed};
    if (is_snapped(land.window.level, controls))
        correct_in_place(land.window,
                         Pass<true>(land, database, controls, of_finest, pinned, pass));
    else
        correct_in_place(land.window,
                         Pass<false>(land, database, controls, guidance, pinned, pass));
}

void lift(Synthesis& land, const Database& database, const CellGuidance& guidance,
          const PinnedRegion& pinned) {
    const Window& w = land.window;
    const Level& level = database.levels[std::size_t(w.level)];
    const float unit = static_cast<float>(database.unit);
    Field<float> heights(w.width, w.height);
    parallel_for(w.height, 16, [&](int y) {
        for (std::size_t i = heights.index(0, y); i < heights.index(0, y) + w.width; ++i)
            if (guidance.pulls[i].reach > 0.0f)
                heights[i] = height_at(level, w.level, spot_of(land.origins[i])) +
                             unit * float(land.offsets[i]);
    });
    const Field<float> rise = residual_correction(
        guidance.pulls, heights, database.spacing * double(1 << w.level));
    for (std::size_t i = 0; i < rise.size(); ++i) {
        land.offsets[i] += static_cast<std::int32_t>(std::lrintf(rise[i] / unit));
        if (!pinned.weights.empty() && pinned.weights[i] == 0.0f)
            land.offsets[i] = pinned.offsets[i];
    }
}

}  // namespace cydonia::texture
