#include "synth/hydrology/depressions.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include "field/parallel.h"
#include "synth/hydrology/neighbours.h"

namespace cydonia::hydrology {
namespace {

// 1 at cells without a lower neighbour that are not at the land's edge.
Field<std::uint8_t> without_lower(const Field<float>& heights) {
    const int width = heights.width();
    Field<std::uint8_t> low(width, heights.height());
    parallel_for(heights.height() - 2, 64, [&](int row) {
        const float* above = heights.data() + heights.index(0, row);
        const float* here = above + width;
        const float* below = here + width;
        std::uint8_t* out = low.data() + low.index(0, row + 1);
        const auto least = [&](int x) {
            return std::min(std::min(above[x], here[x]), below[x]);
        };
        for (int x = 1; x + 1 < width; ++x)
            out[x] = here[x] <= std::min(std::min(least(x - 1), least(x)), least(x + 1));
    });
    return low;
}

// Whether neither the cell nor any connected cell of exactly its height has a lower
// neighbour; marks all of them in `seen`. OpenCV's connectedComponents knows no equality
// of floats.
bool is_minimum(const Field<float>& heights, const Field<std::uint8_t>& low,
                std::int32_t cell, Field<std::uint8_t>& seen) {
    bool minimum = true;
    std::vector<std::int32_t> level{cell};
    seen[cell] = 1;
    while (!level.empty()) {
        const std::int32_t here = level.back();
        level.pop_back();
        minimum = minimum && low[here];
        for_neighbours(heights, here, [&](std::int32_t next, double) {
            if (heights[next] != heights[here] || seen[next]) return;
            seen[next] = 1;
            level.push_back(next);
        });
    }
    return minimum;
}

// Fills hollows with water, the lowest first. The way out of a hollow then ends at
// another that is full already, or at land that drains, so no cell is filled twice.
class Water {
  public:
    explicit Water(const Field<float>& heights)
        : heights_(heights),
          standing_(heights.width(), heights.height()),
          met_by_(heights.width(), heights.height(), -1) {}

    bool stands_at(std::int32_t cell) const { return standing_[cell] > 0.0f; }
    Field<float> taken_mask() { return std::move(standing_); }

    // The height above the minimum at which the water overflows, metres.
    float fill(std::int32_t minimum) {
        const float bottom = heights_[minimum];
        float level = bottom;
        std::vector<std::int32_t> met;
        std::size_t inside =
            0;  // how many of `met` are filled; the others lie beyond the outlet
        reach(minimum, minimum);
        while (!shore_.empty()) {
            const auto [height, cell] = lowest();
            if (height >= level) {
                level = height;
                inside = met.size();
            }
            // Water finds its way from lower land and from hollows that are full.
            if (height < bottom || stands_at(cell) || at_edge(heights_, cell)) break;
            met.push_back(cell);
            for_neighbours(heights_, cell, [&](std::int32_t next, double) {
                if (met_by_[next] != minimum) reach(next, minimum);
            });
        }
        for (const std::int32_t cell : std::span(met).first(inside))
            if (heights_[cell] < level) standing_[cell] = 1.0f;
        shore_.clear();
        return level - bottom;
    }

  private:
    using Shore = std::pair<float, std::int32_t>;

    void reach(std::int32_t cell, std::int32_t minimum) {
        met_by_[cell] = minimum;
        shore_.emplace_back(heights_[cell], cell);
        std::ranges::push_heap(shore_, std::greater{});
    }
    Shore lowest() {
        std::ranges::pop_heap(shore_, std::greater{});
        const Shore shore = shore_.back();
        shore_.pop_back();
        return shore;
    }

    const Field<float>& heights_;
    Field<float> standing_;
    Field<std::int32_t> met_by_;  // the last minimum whose water reached the cell
    std::vector<Shore> shore_;    // a heap, lowest on top
};

}  // namespace

std::vector<std::int32_t> minima_of(const Field<float>& heights) {
    std::vector<std::int32_t> minima;
    if (heights.width() < 3 || heights.height() < 3) return minima;
    const Field<std::uint8_t> low = without_lower(heights);
    Field<std::uint8_t> seen(heights.width(), heights.height());
    const auto cells = static_cast<std::int32_t>(heights.size());
    for (std::int32_t cell = 0; cell < cells; ++cell)
        if (low[cell] && !seen[cell] && is_minimum(heights, low, cell, seen))
            minima.push_back(cell);
    std::ranges::stable_sort(minima, {},
                             [&](std::int32_t cell) { return heights[cell]; });
    return minima;
}

double pits_per_1000(const Field<float>& heights) {
    if (heights.width() < 3 || heights.height() < 3) return 0.0;
    std::vector<int> pits(static_cast<std::size_t>(heights.height()));
    parallel_for(heights.height() - 2, 64, [&](int row) {
        const int y = row + 1;
        const float* above = heights.row(y - 1).data();
        const float* here = heights.row(y).data();
        const float* below = heights.row(y + 1).data();
        const auto lower = [](float a, float b) { return a < b ? a : b; };
        for (int x = 1; x + 1 < heights.width(); ++x) {
            const float sides = lower(here[x - 1], here[x + 1]);
            const float north = lower(lower(above[x - 1], above[x]), above[x + 1]);
            const float south = lower(lower(below[x - 1], below[x]), below[x + 1]);
            pits[static_cast<std::size_t>(y)] +=
                here[x] < lower(sides, lower(north, south));
        }
    });
    const double inner = double(heights.width() - 2) * double(heights.height() - 2);
    return 1000.0 * std::accumulate(pits.begin(), pits.end(), 0.0) / inner;
}

Depressions depressions_of(const Field<float>& heights) {
    Depressions found;
    Water water(heights);
    for (const std::int32_t minimum : minima_of(heights)) {
        if (water.stands_at(minimum)) continue;
        ++found.count;
        found.deepest = std::max(found.deepest, water.fill(minimum));
    }
    found.mask = water.taken_mask();
    return found;
}

}  // namespace cydonia::hydrology
