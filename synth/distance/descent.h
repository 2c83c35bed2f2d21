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

// A profile turned over, scaled to sea level and tabulated: cost by horizontal distance
// from a generator of cost 0, strictly increasing from (0, 0), straight beyond the reach.
// Pieces are found both by distance and by cost without a search: neither a bin of
// distance nor one of cost has more than one knot in it. Made by tabulated().
struct Descent {
    double sea_level = 0.0;  // c_s, metres
    double reach = 0.0;      // metres at which the cost is c_s

    // Does not decrease, rounding included. From 0 to infinity.
    float operator()(float distance) const {
        const std::uint16_t* const first = by_distance.data();
        const Knot* knot = &knots[first[bin_of(distance * bins_a_metre)]];
        knot += distance >= knot[1].distance;
        return std::min(knot->cost + (distance - knot->distance) * knot->slope,
                        knot[1].cost);
    }
    // The inverse, up to rounding. From 0 to infinity.
    float distance_at(float cost) const {
        const std::uint16_t* const first = by_cost.data();
        const Knot* knot = &knots[first[bin_of(cost * bins_a_cost)]];
        knot += cost >= knot[1].cost;
        return std::min(knot->distance + (cost - knot->cost) * knot->run,
                        knot[1].distance);
    }
    // The least d cost / d distance where the cost lies between these shares of sea
    // level; past 1 counts as 1. Up to a thousandth too little, never too much.
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

// `line`: from (0, 0), at least two points, both coordinates rising strictly; its end is
// kept, the rest may move by two of 4096 parts of the reach or of sea level.
Descent tabulated(std::span<const CostPoint> line);

}  // namespace cydonia::distance
