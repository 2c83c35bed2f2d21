#include "synth/distance/descent.h"

#include <bit>
#include <cassert>
#include <cmath>

namespace cydonia::distance {
namespace {

// A little more than a bin, so that rounding puts no two knots into one bin.
constexpr double kApart = 1.01 / Descent::kBins;

// The line with its points at least `apart` from one another in distance and in cost. A
// run of points too close to the one before is replaced by its last point, moved away by
// less than `apart`, so that ledges and cliffs stay at the height and distance where they
// end.
std::vector<CostPoint> spaced(std::span<const CostPoint> line) {
    const CostPoint end = line.back();
    const CostPoint apart{kApart * end.distance, kApart * end.cost};
    const CostPoint most{end.distance - apart.distance, end.cost - apart.cost};
    std::vector<CostPoint> kept{line.front()};
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const CostPoint least{kept.back().distance + apart.distance,
                              kept.back().cost + apart.cost};
        const auto close = [&](const CostPoint& p) {
            return p.distance < least.distance || p.cost < least.cost;
        };
        while (i + 2 < line.size() && close(line[i]) && close(line[i + 1])) ++i;
        const CostPoint p{
            std::max(std::min(line[i].distance, most.distance), least.distance),
            std::max(std::min(line[i].cost, most.cost), least.cost)};
        const bool beside =
            line[i].distance < least.distance && line[i].cost < least.cost;
        if (!beside && p.distance <= most.distance && p.cost <= most.cost) {
            kept.push_back(p);
        }
    }
    kept.push_back(end);
    return kept;
}

std::vector<Descent::Knot> knots_of(std::span<const CostPoint> line) {
    std::vector<Descent::Knot> knots;
    for (const auto [distance, cost] : line) {
        knots.push_back(
            {static_cast<float>(distance), static_cast<float>(cost), 0.0f, 0.0f});
    }
    for (std::size_t i = 0; i < knots.size(); ++i) {
        // Beyond the end the slope continues.
        const std::size_t a = std::min(i, knots.size() - 2);
        const double fall = 1.0 * knots[a + 1].cost - knots[a].cost;
        const double way = 1.0 * knots[a + 1].distance - knots[a].distance;
        knots[i].slope = static_cast<float>(fall / way);
        knots[i].run = static_cast<float>(way / fall);
    }
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    knots.push_back({kInfinity, kInfinity, 0.0f, 0.0f});
    return knots;
}

std::vector<std::uint16_t> index_of(std::span<const Descent::Knot> knots,
                                    float Descent::Knot::*place, float bins_a_unit) {
    std::vector<std::uint16_t> first(Descent::kBins);
    std::size_t k = 0;
    for (int bin = 0; bin < Descent::kBins; ++bin) {
        while (knots[k + 1].*place * bins_a_unit < static_cast<float>(bin)) ++k;
        first[bin] = static_cast<std::uint16_t>(k);
    }
    return first;
}

std::vector<std::array<float, Descent::kSlopeBins>> least_slopes_of(
    std::span<const Descent::Knot> knots, double sea_level) {
    constexpr int kBins = Descent::kSlopeBins;
    std::vector<std::array<float, kBins>> levels(Descent::kSlopeLevels);
    levels[0].fill(std::numeric_limits<float>::infinity());
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        // A little beyond the segment, because shares are rounded.
        const double low = knots[k].cost / sea_level * kBins - 0.01;
        const double high = knots[k + 1].cost / sea_level * kBins + 0.01;
        const int first = static_cast<int>(std::clamp(low, 0.0, kBins - 1.0));
        const int last = static_cast<int>(std::clamp(high, 0.0, kBins - 1.0));
        for (int bin = first; bin <= last; ++bin) {
            levels[0][bin] = std::min(levels[0][bin], 0.999f * knots[k].slope);
        }
    }
    for (int level = 1; level < Descent::kSlopeLevels; ++level) {
        const int half = 1 << (level - 1);
        for (int bin = 0; bin < kBins; ++bin) {
            levels[level][bin] =
                std::min(levels[level - 1][bin],
                         levels[level - 1][std::min(bin + half, kBins - 1)]);
        }
    }
    return levels;
}

}  // namespace

float Descent::least_slope(float low, float high) const {
    const auto bin = [](float share) {
        return static_cast<int>(std::clamp(share * kSlopeBins, 0.0f, kSlopeBins - 1.0f));
    };
    const int first = bin(low), last = bin(high);
    assert(first <= last);
    const int level = std::bit_width(static_cast<unsigned>(last - first + 1)) - 1;
    return std::min(least_slopes[level][first],
                    least_slopes[level][last + 1 - (1 << level)]);
}

Descent tabulated(std::span<const CostPoint> line) {
    assert(line.size() >= 2 && line.front().distance == 0.0 && line.front().cost == 0.0);
    Descent descent;
    descent.reach = line.back().distance;
    descent.sea_level = line.back().cost;
    descent.knots = knots_of(spaced(line));
    descent.bins_a_metre = static_cast<float>(Descent::kBins / descent.reach);
    descent.bins_a_cost = static_cast<float>(Descent::kBins / descent.sea_level);
    descent.by_distance =
        index_of(descent.knots, &Descent::Knot::distance, descent.bins_a_metre);
    descent.by_cost = index_of(descent.knots, &Descent::Knot::cost, descent.bins_a_cost);
    descent.least_slopes = least_slopes_of(descent.knots, descent.sea_level);
    return descent;
}

}  // namespace cydonia::distance
