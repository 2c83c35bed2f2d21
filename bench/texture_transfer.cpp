#include "bench/texture_transfer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "field/random.h"

namespace cydonia::bench {
namespace {

constexpr int kIterations = 3, kBlock = 16, kCandidates = 50;
constexpr double kOverlap = 0.17;

// Where a seam runs through an overlap: for each row the first column that is new.
std::vector<int> cut(int rows, int columns, const auto& error) {
    std::vector<double> cost(std::size_t(rows * columns));
    const auto at = [&](int r, int c) -> double& {
        return cost[std::size_t(r * columns + c)];
    };
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            double least = r == 0 ? 0.0 : HUGE_VAL;
            for (int p = std::max(0, c - 1); r > 0 && p <= std::min(columns - 1, c + 1);
                 ++p)
                least = std::min(least, at(r - 1, p));
            at(r, c) = error(r, c) + least;
        }
    std::vector<int> seam(std::size_t(rows), 0);
    for (int r = rows - 1, c = -1; r >= 0; --r) {
        const int from = c < 0 ? 0 : std::max(0, c - 1),
                  to = c < 0 ? columns - 1 : std::min(columns - 1, c + 1);
        int best = from;
        for (int p = from; p <= to; ++p)
            if (at(r, p) < at(r, best)) best = p;
        seam[std::size_t(r)] = c = best;
    }
    return seam;
}

}  // namespace

Field<float> texture_transferred(const Field<float>& base, const Field<float>& example,
                                 std::uint64_t seed) {
    Field<float> land = base;
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        const int block =
            std::max(4, int(std::lround(kBlock * std::pow(2.0 / 3.0, iteration))));
        const int overlap = std::max(2, int(std::lround(kOverlap * block)));
        const double alpha = 0.8 * iteration / (kIterations - 1) + 0.1;
        const Field<float> before = land;
        for (int y0 = 0; y0 < land.height(); y0 += block - overlap)
            for (int x0 = 0; x0 < land.width(); x0 += block - overlap) {
                const int w = std::min(block, land.width() - x0),
                          h = std::min(block, land.height() - y0);
                if (w <= overlap || h <= overlap) continue;
                const auto raised = [&](int ex, int ey) {
                    double sum = 0.0;
                    for (int y = 0; y < h; ++y)
                        for (int x = 0; x < w; ++x)
                            sum += base(x0 + x, y0 + y) - example(ex + x, ey + y);
                    return float(sum / (double(w) * h));
                };
                double least = HUGE_VAL;
                int bx = 0, by = 0;
                float lift = 0.0f;
                for (int k = 0; k < kCandidates; ++k) {
                    const auto place = [&](const char* axis, int room) {
                        const std::uint64_t hash = hash_of(
                            {seed, key(axis), std::uint64_t(iteration), std::uint64_t(x0),
                             std::uint64_t(y0), std::uint64_t(k)});
                        return int(unit(hash) * room);
                    };
                    const int ex = place("x", example.width() - w + 1),
                              ey = place("y", example.height() - h + 1);
                    const float up = raised(ex, ey);
                    double like = 0.0, meets = 0.0;
                    for (int y = 0; y < h; ++y)
                        for (int x = 0; x < w; ++x) {
                            const double value = example(ex + x, ey + y) + up;
                            const double off = value - base(x0 + x, y0 + y);
                            like += off * off;
                            const bool old =
                                (x < overlap && x0 > 0) || (y < overlap && y0 > 0);
                            if (!old && iteration == 0) continue;
                            const double step =
                                value - (old ? land : before)(x0 + x, y0 + y);
                            meets += step * step;
                        }
                    const double cost = alpha * meets + (1.0 - alpha) * like;
                    if (cost < least) least = cost, bx = ex, by = ey, lift = up;
                }
                const auto error = [&](int x, int y) {
                    const double step =
                        example(bx + x, by + y) + lift - land(x0 + x, y0 + y);
                    return step * step;
                };
                std::vector<int> west(std::size_t(h), 0), north(std::size_t(w), 0);
                if (x0 > 0)
                    west = cut(h, overlap, [&](int r, int c) { return error(c, r); });
                if (y0 > 0)
                    north = cut(w, overlap, [&](int r, int c) { return error(r, c); });
                for (int y = 0; y < h; ++y)
                    for (int x = 0; x < w; ++x)
                        if (x >= west[std::size_t(y)] && y >= north[std::size_t(x)])
                            land(x0 + x, y0 + y) = example(bx + x, by + y) + lift;
            }
    }
    return land;
}

}  // namespace cydonia::bench
