#include "synth/texture/constraints/residual.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "field/parallel.h"

namespace cydonia::texture {
namespace {

constexpr int kRows = 8;  // at a time

// A cell that a constraint passes through.
struct Own {
    int x;
    float residual;  // metres
};
using Owns = std::vector<std::vector<Own>>;  // by rows, from west to east

// 1 at 0, and 0 from 1 on, without a slope at either.
double bell(double squared) {
    const double u = std::max(0.0, 1.0 - squared);
    return u * u;
}

// Values of a function of the squared distance around a cell.
template <class Function>
Field<float> kernel(int radius, const Function& function) {
    Field<float> values(2 * radius + 1, 2 * radius + 1);
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x)
            values(x + radius, y + radius) = static_cast<float>(function(x * x + y * y));
    return values;
}

Owns owns_of(const Field<Pull>& pulls, const Field<float>& heights, float near) {
    Owns rows(static_cast<std::size_t>(pulls.height()));
    parallel_for(pulls.height(), kRows, [&](int y) {
        for (int x = 0; x < pulls.width(); ++x) {
            const Pull& pull = pulls(x, y);
            if (pull.reach > 0.0f && pull.distance < near)
                rows[y].push_back({x, pull.target - heights(x, y)});
        }
    });
    return rows;
}

// Calls act(own, its row - y) for all cells within `radius` rows of row y, from north to
// south.
template <class Act>
void for_near(const Owns& rows, int y, int radius, const Act& act) {
    const int last = std::min(y + radius, static_cast<int>(rows.size()) - 1);
    for (int row = std::max(0, y - radius); row <= last; ++row)
        for (const Own& own : rows[row]) act(own, row - y);
}

// Each residual replaced by the mean over the constraint's cells within `radius`.
Owns averaged(const Owns& rows, int radius) {
    const Field<float> weights = kernel(
        radius, [&](int squared) { return bell(squared / (double(radius) * radius)); });
    Owns means = rows;
    parallel_for(static_cast<int>(rows.size()), kRows, [&](int y) {
        if (rows[y].empty()) return;
        std::vector<double> sums(rows[y].size(), 0.0), counts(rows[y].size(), 0.0);
        for_near(rows, y, radius, [&](const Own& other, int dy) {
            const auto first =
                std::lower_bound(rows[y].begin(), rows[y].end(), other.x - radius,
                                 [](const Own& own, int x) { return own.x < x; });
            for (auto own = first; own != rows[y].end() && own->x <= other.x + radius;
                 ++own) {
                const auto i = static_cast<std::size_t>(own - rows[y].begin());
                const float w = weights(other.x - own->x + radius, dy + radius);
                sums[i] += double(w) * other.residual;
                counts[i] += w;
            }
        });
        for (std::size_t i = 0; i < sums.size(); ++i)
            means[y][i].residual = static_cast<float>(sums[i] / counts[i]);
    });
    return means;
}

// The residual of the nearest constraints at each cell, and the share of it that is
// applied.
struct Carried {
    Field<float> residual, share;
};

Carried carried(const Owns& rows, int width, int radius) {
    const int height = static_cast<int>(rows.size());
    const double squared_radius = double(radius) * radius;
    // The kernel is steep in the middle, so that on a constraint its own residual
    // dominates.
    const Field<float> weights = kernel(radius, [&](int squared) {
        return bell(squared / squared_radius) / ((squared + 1.0) * (squared + 1.0));
    });
    const Field<float> distances = kernel(radius, [](int squared) { return squared; });
    Carried carried{{width, height, 0.0f}, {width, height, 0.0f}};
    parallel_for(height, kRows, [&](int y) {
        std::vector<float> sums, nearest;
        const std::span<float> residual = carried.residual.row(y);
        for_near(rows, y, radius, [&](const Own& own, int dy) {
            if (sums.empty()) {
                sums.assign(static_cast<std::size_t>(width), 0.0f);
                nearest.assign(sums.size(), std::numeric_limits<float>::infinity());
            }
            const int x0 = std::max(0, own.x - radius);
            const int x1 = std::min(width - 1, own.x + radius);
            const float* w = &weights(x0 - own.x + radius, dy + radius) - x0;
            const float* d = &distances(x0 - own.x + radius, dy + radius) - x0;
            for (int x = x0; x <= x1; ++x) {
                sums[x] += w[x];
                residual[x] += w[x] * own.residual;
                nearest[x] = std::min(nearest[x], d[x]);
            }
        });
        if (sums.empty()) return;
        for (int x = 0; x < width; ++x) {
            if (!(sums[x] > 0.0f)) continue;
            residual[x] /= sums[x];
            carried.share(x, y) = static_cast<float>(bell(nearest[x] / squared_radius));
        }
    });
    return carried;
}

// The larger of a cell's value and the binomial mean of the 5x5 cells around it. This
// fills creases where two constraints are equally near and loses nothing on the
// constraints.
float uncreased(const Field<float>& share, int x, int y) {
    constexpr float kWeights[] = {1 / 16.0f, 4 / 16.0f, 6 / 16.0f, 4 / 16.0f, 1 / 16.0f};
    float mean = 0.0f;
    for (int dy = -2; dy <= 2; ++dy) {
        const int row = std::clamp(y + dy, 0, share.height() - 1);
        float sum = 0.0f;
        for (int dx = -2; dx <= 2; ++dx)
            sum +=
                kWeights[dx + 2] * share(std::clamp(x + dx, 0, share.width() - 1), row);
        mean += kWeights[dy + 2] * sum;
    }
    return std::max(share(x, y), mean);
}

}  // namespace

Field<float> residual_correction(const Field<Pull>& pulls, const Field<float>& heights,
                                 double cell, const ResidualSpread& spread) {
    assert(pulls.same_shape(heights) && spread.radius > 0 && spread.along > 0);
    Field<float> correction(heights.width(), heights.height(), 0.0f);
    Owns rows = owns_of(pulls, heights, static_cast<float>(spread.near * cell));
    const auto none = [](const std::vector<Own>& row) { return row.empty(); };
    if (std::all_of(rows.begin(), rows.end(), none)) return correction;
    rows = averaged(rows, spread.along);
    const Carried parts = carried(rows, heights.width(), spread.radius);
    parallel_for(heights.height(), kRows, [&](int y) {
        for (int x = 0; x < heights.width(); ++x)
            if (parts.share(x, y) > 0.0f)
                correction(x, y) = parts.residual(x, y) * uncreased(parts.share, x, y);
    });
    return correction;
}

}  // namespace cydonia::texture
