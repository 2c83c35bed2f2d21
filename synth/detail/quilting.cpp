#include "synth/detail/quilting.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "field/parallel.h"

namespace cydonia::detail {
namespace {

// A run of values along one axis that lie in the same one or two blocks.
struct Run {
    int begin, end, block;
    bool fades = false;  // into the next block
    // How far it has faded at a value, 0 to 1.
    float at(int value) const {
        return (float(value - begin) + 0.5f) / float(end - begin);
    }
};

// The runs of an axis from value `from` to `to`, where details have `scale` values for
// each coarse cell.
std::vector<Run> runs_of(int blocks, int step, int overlap, int scale, int from, int to) {
    std::vector<Run> runs;
    for (int b = 0; b < blocks; ++b) {
        const int begin = b == 0 ? 0 : (b * step + overlap) * scale;
        const int next = (b + 1) * step * scale, after = next + overlap * scale;
        if (b + 1 == blocks) {
            runs.push_back({begin, std::max(begin, to), b});
        } else {
            runs.push_back({begin, next, b});
            runs.push_back({next, after, b, true});
        }
    }
    std::erase_if(runs,
                  [&](const Run& run) { return run.end <= from || run.begin >= to; });
    return runs;
}

// A part of an example under a run of a row, and its weight: `weight` at the begin of the
// run and `change` more at its end.
struct Land {
    Match match;
    float weight, change;
    const float* row = nullptr;  // null where the example has no details
    int shift = 0, begin = 0, end = 0;
};

// The land of up to four blocks in one row of a run. Blocks with the same match count as
// one.
class Pile {
  public:
    void add(const Match& match, float weight, float change) {
        for (Land& land : std::span(lands_).first(count_))
            if (land.match == match) {
                land.weight += weight, land.change += change;
                return;
            }
        lands_[count_++] = {match, weight, change};
    }
    std::span<Land> lands() { return std::span(lands_).first(count_); }

  private:
    std::array<Land, 4> lands_;
    std::size_t count_ = 0;
};

// `to` is as long as `from` to `end`.
void sum_up(std::span<Land> lands, const Run& run, Fading fading, int from,
            std::span<float> to) {
    const int end = std::min(run.end, from + int(to.size()));
    for (int x = std::max(run.begin, from); x < end; ++x) {
        const float t = run.at(x);
        float sum = 0.0f, squares = 0.0f;
        for (const Land& land : lands) {
            const float weight = land.weight + t * land.change;
            squares += weight * weight;
            if (land.begin <= x && x < land.end) sum += weight * land.row[x + land.shift];
        }
        to[std::size_t(x - from)] =
            fading == Fading::kMean ? sum : sum / std::sqrt(squares);
    }
}

// `of` gives the details of an example, of columns or of rows. They have `scale` values
// for each coarse cell from west to east and one from north to south.
template <class Of>
void blend(const Window& window, const Blocks& blocks, std::span<const Match> matches,
           const Of& of, int scale, Fading fading, Field<float>& out) {
    const int across = blocks.across(), left = scale * window.x;
    const auto east =
        runs_of(across, blocks.step, blocks.overlap, scale, left, left + out.width());
    const auto south = runs_of(blocks.down(), blocks.step, blocks.overlap, 1, window.y,
                               window.y + out.height());
    parallel_for(int(south.size()), [&](int i) {
        const Run& rows = south[std::size_t(i)];
        const int end = std::min(rows.end, window.y + out.height());
        for (int y = std::max(rows.begin, window.y); y < end; ++y)
            for (const Run& run : east) {
                Pile pile;
                const auto lay = [&](int row, float weight) {
                    const Match* match = &matches[std::size_t(row * across + run.block)];
                    pile.add(match[0], weight, run.fades ? -weight : 0.0f);
                    if (run.fades) pile.add(match[1], 0.0f, weight);
                };
                const float below = rows.fades ? rows.at(y) : 0.0f;
                lay(rows.block, 1.0f - below);
                if (rows.fades) lay(rows.block + 1, below);
                for (Land& land : pile.lands()) {
                    if (land.match.example < 0) continue;
                    const Field<float>& from = of(land.match.example);
                    const int row = y + land.match.dy;
                    if (row < 0 || row >= from.height()) continue;
                    land.row = from.row(row).data();
                    land.shift = scale * land.match.dx;
                    land.begin = -land.shift, land.end = from.width() - land.shift;
                }
                sum_up(pile.lands(), run, fading, left, out.row(y - window.y));
            }
    });
}

}  // namespace

Details quilted(int coarse_width, int coarse_height, const Window& window,
                const Blocks& blocks, std::span<const Match> matches,
                std::span<const Example> examples, int level, Filter filter,
                Fading fading) {
    Details details = no_details(filter, coarse_width, coarse_height);
    const auto of = [&](int example) -> const Details& {
        return examples[std::size_t(example)].level(level)->details;
    };
    blend(
        window, blocks, matches,
        [&](int e) -> const Field<float>& { return of(e).columns; }, 2, fading,
        details.columns);
    blend(
        window, blocks, matches, [&](int e) -> const Field<float>& { return of(e).rows; },
        1, fading, details.rows);
    return details;
}

}  // namespace cydonia::detail
