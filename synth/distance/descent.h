#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cydonia::distance {

struct CostPoint {
    double distance, cost;  // metres
};

// A profile turned upside down, scaled to sea level and tabulated: cost by horizontal
// distance from a generator of cost 0. It strictly increases from (0, 0) and is straight
// beyond the reach. Segments are found by distance and by cost without a search, because
// no bin of distance or of cost contains more than one knot. Made by tabulated().
struct Descent {
    double sea_level = 0.0;  // c_s, metres
    double reach = 0.0;      // metres at which the cost is c_s

    // The cost at a distance from 0 to infinity. It does not decrease, even with
    // rounding.
    float operator()(float distance) const {
        const std::uint16_t* const first = by_distance.data();
        const Knot* knot = &knots[first[bin_of(distance * bins_a_metre)]];
        knot += distance >= knot[1].distance;
        return std::min(knot->cost + (distance - knot->distance) * knot->slope,
                        knot[1].cost);
    }
    // The inverse, up to rounding, for a cost from 0 to infinity.
    float distance_at(float cost) const {
        const std::uint16_t* const first = by_cost.data();
        const Knot* knot = &knots[first[bin_of(cost * bins_a_cost)]];
        knot += cost >= knot[1].cost;
        return std::min(knot->distance + (cost - knot->cost) * knot->run,
                        knot[1].distance);
    }
    // The least d cost / d distance where the cost lies between these shares of sea
    // level; shares above 1 count as 1. It may be up to a thousandth too small, but never
    // too large.
    float least_slope(float low, float high) const;

    static constexpr int kBins = 4096;
    static constexpr int kSlopeBins = 512, kSlopeLevels = 10;
    struct Knot {
        float distance, cost;
        float slope, run;  // to the next: cost by distance, distance by cost
    };
    std::vector<Knot> knots;  // the last but one at (reach, c_s), the last at infinity
    // The last knot before each bin, that of bin 0 at 0.
    std::vector<std::uint16_t> by_distance, by_cost;
    float bins_a_metre = 0.0f, bins_a_cost = 0.0f;
    // [level][i]: of 2^level bins of cost from i on.
    std::vector<std::array<float, kSlopeBins>> least_slopes;

  private:
    static int bin_of(float place) {
        return static_cast<int>(std::min(place, static_cast<float>(kBins - 1)));
    }
};

// `line` begins at (0, 0) and has at least two points, whose coordinates both rise
// strictly. Its end is kept; the other points may move by 2/4096 of the reach or of sea
// level.
Descent tabulated(std::span<const CostPoint> line);

}  // namespace cydonia::distance
