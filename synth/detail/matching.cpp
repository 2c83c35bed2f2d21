#include "synth/detail/matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "field/error.h"
#include "field/parallel.h"
#include "field/random.h"

namespace cydonia::detail {
namespace {

// The border of an example that no block touches, in cells, because details there come
// from filters for ends.
constexpr int kMargin = 2;
constexpr int kLeastSide = 4;  // cells
// The factor of the cost of a match that continues the next coarser level's match, as a
// landform has details on more than one level.
constexpr float kCoherent = 0.5f;
constexpr int kMostTries = 8;  // for each candidate, as some lie in unknown land
constexpr int kRounds = 4;     // of PatchMatch

struct Rect {
    int x, y, width, height;
};

Rect rect_of(const Blocks& blocks, int block) {
    const int x = block % blocks.across() * blocks.step,
              y = block / blocks.across() * blocks.step;
    return {x, y, std::min(blocks.side(), blocks.width - x),
            std::min(blocks.side(), blocks.height - y)};
}

// The positions of a block in an example: origins kMargin .. kMargin + across - 1.
struct Room {
    int across = 0, down = 0;
    bool any() const { return across > 0 && down > 0; }
};
Room room_in(const Field<float>& coarse, const Rect& r) {
    return {coarse.width() - r.width - 2 * kMargin + 1,
            coarse.height() - r.height - 2 * kMargin + 1};
}

struct Candidate {
    Match match;
    float cost = std::numeric_limits<float>::infinity();
};

// Searches those examples that have details for one level.
class Finder {
  public:
    Finder(const Field<float>& land, const Window& window,
           std::span<const Example> examples, const Searching& searching)
        : land_(land), window_(window), examples_(examples), searching_(searching) {}

    bool holds(const Rect& r) const {
        return land_.contains(r.x - window_.x, r.y - window_.y) &&
               land_.contains(r.x + r.width - 1 - window_.x,
                              r.y + r.height - 1 - window_.y);
    }

    // The best match of a block by itself: of some at random, of all, or of `first`.
    Candidate best(const Rect& r, int block, std::span<const Match> first) const {
        Candidate best;
        for (const Match& match : first) consider(r, match, best);
        best.cost *= kCoherent;
        if (searching_.search == Search::kExhaustive)
            every(r, best);
        else
            random(r, block, best);
        return best;
    }

    // Makes a candidate the best match if it is better. Returns whether it can be used at
    // all.
    bool consider(const Rect& r, const Match& match, Candidate& best) const {
        const float cost = unlike(r, match);
        if (cost < best.cost) best = {match, cost};
        return std::isfinite(cost);
    }

    // Tries random positions around a match, at distances that halve.
    void around(const Rect& r, int block, int round, Candidate& best) const {
        if (best.match.example < 0) return;
        const Field<float>& coarse = coarse_of(best.match.example)->coarse;
        int reach = std::max(coarse.width(), coarse.height()) / 2;
        for (std::uint64_t i = 0; reach >= 1; reach /= 2, ++i) {
            const auto step = [&](std::uint64_t axis) {
                return int(signed_unit(hash_of({searching_.seed, key("around"),
                                                std::uint64_t(block),
                                                std::uint64_t(round), i, axis})) *
                           (reach + 1));
            };
            Match match = best.match;
            match.dx += step(0), match.dy += step(1);
            consider(r, match, best);
        }
    }

    bool fits(const Rect& r) const {
        return std::ranges::any_of(examples_, [&](const Example& example) {
            const Level* level = example.level(searching_.level);
            return level && room_in(level->coarse, r).any();
        });
    }

  private:
    const float* row_of(const Rect& r, int y) const {
        return &land_(r.x - window_.x, r.y + y - window_.y);
    }
    const Level* coarse_of(int example) const {
        return examples_[std::size_t(example)].level(searching_.level);
    }

    // The mean squared difference without the difference of the means; infinite where the
    // block does not fit or heights are not known.
    float unlike(const Rect& r, const Match& match) const {
        constexpr float kNever = std::numeric_limits<float>::infinity();
        if (match.example < 0) return kNever;
        const Example& example = examples_[std::size_t(match.example)];
        const Level* level = example.level(searching_.level);
        if (!level) return kNever;
        const Room room = room_in(level->coarse, r);
        const int x0 = r.x + match.dx, y0 = r.y + match.dy;
        if (x0 < kMargin || y0 < kMargin || x0 >= kMargin + room.across ||
            y0 >= kMargin + room.down)
            return kNever;
        if (!example.unknown.empty()) {
            const auto& unknown =
                example.unknown[std::size_t(searching_.level - example.first)];
            for (int y = 0; y < r.height; ++y)
                for (int x = 0; x < r.width; ++x)
                    if (unknown(x0 + x, y0 + y)) return kNever;
        }
        // Separate lanes, so that the compiler may use vectors and all machines still add
        // in the same order.
        constexpr int kLanes = 8;
        std::array<float, kLanes> sum{}, squares{};
        const float offset = row_of(r, 0)[0] - level->coarse(x0, y0);
        for (int y = 0; y < r.height; ++y) {
            const float* a = row_of(r, y);
            const float* b = &level->coarse(x0, y0 + y);
            int x = 0;
            for (; x + kLanes <= r.width; x += kLanes)
                for (std::size_t k = 0; k < kLanes; ++k) {
                    const float d = a[x + int(k)] - b[x + int(k)] - offset;
                    sum[k] += d, squares[k] += d * d;
                }
            for (; x < r.width; ++x) {
                const float d = a[x] - b[x] - offset;
                sum[0] += d, squares[0] += d * d;
            }
        }
        double all = 0.0, all_squares = 0.0;
        for (std::size_t k = 0; k < kLanes; ++k) all += sum[k], all_squares += squares[k];
        const double cells = double(r.width) * r.height, mean = all / cells;
        return float(all_squares / cells - mean * mean);
    }

    void random(const Rect& r, int block, Candidate& best) const {
        double places = 0.0, fit = 0.0;
        for_all([&](int, const Level& level) {
            const Room room = room_in(level.coarse, r);
            if (!room.any()) return;
            places += double(room.across) * room.down;
            fit +=
                (1.0 + (room.across - 1) / r.width) * (1.0 + (room.down - 1) / r.height);
        });
        const int wanted = int(std::min<double>(searching_.candidates, fit));
        for (int i = 0, found = 0; found < wanted && i < kMostTries * wanted; ++i) {
            const std::uint64_t h = hash_of({searching_.seed, key("candidate"),
                                             std::uint64_t(block), std::uint64_t(i)});
            double at = unit(h) * places;
            for_all([&](int e, const Level& level) {
                const Room room = room_in(level.coarse, r);
                if (!room.any()) return;
                const double here = double(room.across) * room.down;
                if (at >= 0.0 && at < here) {
                    const int column = int(at) % room.across, row = int(at) / room.across;
                    found += consider(r, {e, kMargin + column - r.x, kMargin + row - r.y},
                                      best);
                }
                at -= here;
            });
        }
    }

    // |a - b|^2 = |a|^2 + |b|^2 - 2 a.b, where Fourier transforms give all products at
    // once.
    void every(const Rect& r, Candidate& best) const {
        cv::Mat block(r.height, r.width, CV_32F);
        double mean = 0.0;
        for (int y = 0; y < r.height; ++y)
            for (int x = 0; x < r.width; ++x)
                mean += row_of(r, y)[x] / (double(r.width) * r.height);
        for (int y = 0; y < r.height; ++y)
            for (int x = 0; x < r.width; ++x)
                block.at<float>(y, x) = float(row_of(r, y)[x] - mean);
        for_all([&](int e, const Level& level) {
            const Room room = room_in(level.coarse, r);
            if (!room.any()) return;
            const Field<float>& coarse = level.coarse;
            const cv::Mat land(coarse.height(), coarse.width(), CV_32F,
                               const_cast<float*>(coarse.row(0).data()));
            cv::Mat products, sums, squares;
            cv::matchTemplate(land, block, products, cv::TM_CCOEFF);
            cv::integral(land, sums, squares, CV_64F, CV_64F);
            const double cells = double(r.width) * r.height;
            std::array<Candidate, 4>
                least;  // of the estimates, as rounding may swap the first
            for (int y = kMargin; y < kMargin + room.down; ++y)
                for (int x = kMargin; x < kMargin + room.across; ++x) {
                    const auto within = [&](const cv::Mat& m) {
                        return m.at<double>(y + r.height, x + r.width) -
                               m.at<double>(y, x + r.width) -
                               m.at<double>(y + r.height, x) + m.at<double>(y, x);
                    };
                    const double sum = within(sums);
                    const float cost = float(within(squares) - sum * sum / cells -
                                             2.0 * products.at<float>(y, x));
                    if (!(cost < least.back().cost)) continue;
                    least.back() = {{e, x - r.x, y - r.y}, cost};
                    for (std::size_t i = least.size() - 1;
                         i > 0 && least[i].cost < least[i - 1].cost; --i)
                        std::swap(least[i], least[i - 1]);
                }
            for (const Candidate& candidate : least) consider(r, candidate.match, best);
        });
    }

    template <class Visit>
    void for_all(const Visit& visit) const {
        for (int e = 0; e < int(examples_.size()); ++e)
            if (const Level* level = coarse_of(e)) visit(e, *level);
    }

    const Field<float>& land_;
    const Window& window_;
    std::span<const Example> examples_;
    const Searching& searching_;
};

// PatchMatch (Barnes et al. 2009) among blocks: a neighbour's match, shifted, may suit a
// block, too. All blocks are improved at once from the matches of the round before, so
// that their order does not matter.
void improved(const Finder& finder, const Blocks& blocks, std::vector<Candidate>& all,
              const std::function<bool(int)>& wanted) {
    const int across = blocks.across(), down = blocks.down();
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<Candidate> before = all;
        parallel_for(across * down, [&](int block) {
            if (!wanted(block)) return;
            const Rect r = rect_of(blocks, block);
            const int c = block % across, row = block / across;
            Candidate& best = all[std::size_t(block)];
            const auto take = [&](int other) {
                finder.consider(r, before[std::size_t(other)].match, best);
            };
            if (c > 0) take(block - 1);
            if (c + 1 < across) take(block + 1);
            if (row > 0) take(block - across);
            if (row + 1 < down) take(block + across);
            finder.around(r, block, round, best);
        });
    }
}

}  // namespace

Blocks blocks_of(int width, int height, int side) {
    side = std::max(kLeastSide, side);
    const int overlap = side / 4;
    return {width, height, side - overlap, overlap};
}

std::vector<Match> matched(const Field<float>& land, const Window& window,
                           const Blocks& blocks, std::span<const Example> examples,
                           const Searching& searching, const Blocks& blocks_before,
                           std::span<const Match> before,
                           const std::function<bool(int block)>& asked) {
    const Finder finder(land, window, examples, searching);
    const auto wanted = [&](int block) {
        return finder.holds(rect_of(blocks, block)) && asked(block);
    };
    const int count = blocks.across() * blocks.down();
    if (!finder.fits(rect_of(blocks, 0)))
        throw bad_request(
            "no target has room for a block of {0} x {0} cells of {1} x {1} samples of "
            "the "
            "land: give a larger model, fewer levels or a smaller block",
            blocks.side(), 2 << searching.level);
    std::vector<Candidate> all(static_cast<std::size_t>(count));
    parallel_for(count, [&](int block) {
        if (!wanted(block)) return;
        const Rect r = rect_of(blocks, block);
        std::vector<Match> first;
        if (!before.empty()) {
            // The same position on the next coarser level.
            Match match = before[std::size_t(
                blocks_before.at((r.x + r.width / 2) / 2, (r.y + r.height / 2) / 2))];
            match.dx *= 2, match.dy *= 2;
            first.push_back(match);
        }
        all[std::size_t(block)] = finder.best(r, block, first);
    });
    if (searching.search == Search::kPatchMatch) improved(finder, blocks, all, wanted);
    std::vector<Match> matches;
    bool any = false, found = false;
    for (int block = 0; block < count; ++block) {
        matches.push_back(all[std::size_t(block)].match);
        any |= wanted(block), found |= matches.back().example >= 0;
    }
    if (any && !found)
        throw bad_request(
            "nowhere in the targets do {0} x {0} cells of {1} x {1} samples of the land "
            "lie "
            "without voids: give a model with fewer, or a smaller block",
            blocks.side(), 2 << searching.level);
    return matches;
}

}  // namespace cydonia::detail
