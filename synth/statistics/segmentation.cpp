#include "synth/statistics/segmentation.h"

#include <algorithm>
#include <cmath>

#include "field/parallel.h"

namespace cydonia::statistics {
namespace {

constexpr int kPasses = 8;
constexpr double kVote =
    1.0;  // weight of all neighbours together; a block's own window has 1

bool has_window(const Analysis& analysis) {
    return analysis[std::size_t(Quantity::kElevation)].count > 0;
}

}  // namespace

std::vector<Analysis> spread_windows(const Field<Analysis>& windows, int most) {
    const int side = std::max(1, int(std::sqrt(double(most))));
    std::vector<Analysis> chosen;
    const auto at = [&](int i, int n) {
        const int count = std::min(side, n);
        return int((i + 0.5) * n / count);
    };
    for (int j = 0; j < std::min(side, windows.height()); ++j)
        for (int i = 0; i < std::min(side, windows.width()); ++i) {
            const Analysis& window =
                windows(at(i, windows.width()), at(j, windows.height()));
            if (has_window(window)) chosen.push_back(window);
        }
    return chosen;
}

Field<int> block_types(const Library& library, const Field<Analysis>& windows) {
    const int w = windows.width(), h = windows.height();
    const std::size_t types = library.types().size();
    Field<int> labels(w, h, kNoType);
    std::vector<Field<double>> like(types, Field<double>(w, h));
    parallel_for(h, [&](int y) {
        for (int x = 0; x < w; ++x) {
            if (!has_window(windows(x, y))) continue;
            for (std::size_t t = 0; t < types; ++t) {
                like[t](x, y) = library.similarity(t, windows(x, y));
                const int best = labels(x, y);
                if (best == kNoType || like[t](x, y) > like[std::size_t(best)](x, y))
                    labels(x, y) = int(t);
            }
        }
    });
    for (int pass = 0; pass < kPasses; ++pass) {
        const Field<int> before = labels;
        parallel_for(h, [&](int y) {
            std::vector<double> votes(types);
            for (int x = 0; x < w; ++x) {
                if (before(x, y) == kNoType) continue;
                int neighbours = 0;
                std::ranges::fill(votes, 0.0);
                for (int q = std::max(0, y - 1); q <= std::min(h - 1, y + 1); ++q)
                    for (int p = std::max(0, x - 1); p <= std::min(w - 1, x + 1); ++p) {
                        if ((p == x && q == y) || before(p, q) == kNoType) continue;
                        const auto t = std::size_t(before(p, q));
                        votes[t] += like[t](p, q), ++neighbours;
                    }
                for (std::size_t t = 0; t < types; ++t)
                    votes[t] = like[t](x, y) + kVote * votes[t] / std::max(1, neighbours);
                labels(x, y) = int(std::ranges::max_element(votes) - votes.begin());
            }
        });
        if (labels == before) break;
    }
    return labels;
}

Field<int> sample_types(const Field<int>& blocks, int width, int height) {
    Field<int> types(width, height, kNoType);
    parallel_for(height, 16, [&](int y) {
        const double v = std::clamp((y + 0.5) / kBlock - 0.5, 0.0, blocks.height() - 1.0);
        const int j = int(v), j1 = std::min(j + 1, blocks.height() - 1);
        for (int x = 0; x < width; ++x) {
            const double u =
                std::clamp((x + 0.5) / kBlock - 0.5, 0.0, blocks.width() - 1.0);
            const int i = int(u), i1 = std::min(i + 1, blocks.width() - 1);
            // The type with the most weight among the four blocks around the sample.
            const std::array<int, 4> type = {blocks(i, j), blocks(i1, j), blocks(i, j1),
                                             blocks(i1, j1)};
            const double a = u - i, b = v - j;
            const std::array<double, 4> weight = {(1 - a) * (1 - b), a * (1 - b),
                                                  (1 - a) * b, a * b};
            double most = -1.0;
            for (std::size_t k = 0; k < 4; ++k) {
                double sum = 0.0;
                for (std::size_t l = 0; l < 4; ++l)
                    if (type[l] == type[k]) sum += weight[l];
                if (sum > most) most = sum, types(x, y) = type[k];
            }
        }
    });
    return types;
}

Rectangle largest_rectangle(const Field<int>& types, int type) {
    Rectangle best;
    const int w = types.width();
    // `up` is how far up the type reaches in each column; `open` is a stack of columns of
    // increasing height.
    std::vector<int> up(std::size_t(w + 1), 0);
    for (int y = 0; y < types.height(); ++y) {
        std::vector<int> open;
        for (int x = 0; x <= w; ++x) {
            if (x < w)
                up[std::size_t(x)] = types(x, y) == type ? up[std::size_t(x)] + 1 : 0;
            while (!open.empty() && up[std::size_t(open.back())] >= up[std::size_t(x)]) {
                const int high = up[std::size_t(open.back())];
                open.pop_back();
                const Rectangle found{open.empty() ? 0 : open.back() + 1, y + 1 - high, x,
                                      y + 1};
                if (found.area() > best.area()) best = found;
            }
            open.push_back(x);
        }
    }
    return best;
}

}  // namespace cydonia::statistics
