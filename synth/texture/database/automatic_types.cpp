// Sorts exemplars into types by their land, which Gain, Merry and Marais 2015 left open:
// k-means (Lloyd 1982) on slope, relief and curvature at three scales.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "field/parallel.h"
#include "synth/texture/database/looks.h"
#include "synth/texture/database/types.h"
#include "synth/texture/database/window_sums.h"

namespace cydonia::texture {
namespace {

constexpr std::size_t kLooks = std::tuple_size_v<Look>;
constexpr int kRounds = 60;              // of Lloyd's algorithm, at most
constexpr std::size_t kSamples = 40000;  // blocks from which the centres are found
constexpr int kMajority = 4;             // radius, blocks
constexpr double kMuchWater = 0.02;      // share of all blocks that makes water a type

// Calls visit(look) for every block that is not level.
template <class All, class Visit>
void for_land(All& all, const Visit& visit) {
    for (auto& looks : all)
        for (std::size_t i = 0; i < looks.numbers.size(); ++i)
            if (!looks.level[i]) visit(looks.numbers[i]);
}

std::size_t land_of(const std::vector<Looks>& all) {
    std::size_t blocks = 0;
    for_land(all, [&](const Look&) { ++blocks; });
    return blocks;
}

// Scales each number to a mean of 0 and a deviation of 1 over all land.
void standardise(std::vector<Looks>& all) {
    const double count = double(std::max<std::size_t>(1, land_of(all)));
    for (std::size_t k = 0; k < kLooks; ++k) {
        double sum = 0.0, squares = 0.0;
        for_land(all, [&](const Look& look) {
            const double value = static_cast<double>(look[k]);
            sum += value;
            squares += value * value;
        });
        const double mean = sum / count;
        const double spread = std::sqrt(std::max(0.0, squares / count - mean * mean));
        const double scale = spread > 1e-6 ? 1.0 / spread : 0.0;
        for_land(all, [&](Look& look) {
            look[k] = static_cast<float>((static_cast<double>(look[k]) - mean) * scale);
        });
    }
}

float ruggedness(const Look& look) {
    float sum = 0.0f;
    for (const float value : look) sum += value;
    return sum;
}

float distance(const Look& a, const Look& b) {
    float sum = 0.0f;
    for (std::size_t k = 0; k < kLooks; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

std::size_t nearest(const std::vector<Look>& centres, const Look& look) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < centres.size(); ++i)
        if (distance(centres[i], look) < distance(centres[best], look)) best = i;
    return best;
}

// A sample of all land, evenly spread and sorted from calm to rugged, from which the
// centres are found.
std::vector<Look> samples_of(const std::vector<Looks>& all) {
    const std::size_t step = land_of(all) / kSamples + 1;
    std::vector<Look> samples;
    std::size_t at = 0;
    for_land(all, [&](const Look& look) {
        if (at++ % step == 0) samples.push_back(look);
    });
    std::ranges::stable_sort(samples, {}, ruggedness);
    return samples;
}

// First centres, at equal steps from the calmest to the most rugged, however much land
// there is of each. Quantiles would give most of them to a plain.
std::vector<Look> first_centres(const std::vector<Look>& samples, int types) {
    const float low = ruggedness(samples.front()), high = ruggedness(samples.back());
    std::vector<Look> centres;
    for (int i = 0; i < types; ++i) {
        const float wanted = low + (high - low) * (static_cast<float>(i) + 0.5f) /
                                       static_cast<float>(types);
        const auto found = std::ranges::lower_bound(samples, wanted, {}, ruggedness);
        centres.push_back(found == samples.end() ? samples.back() : *found);
    }
    return centres;
}

// Lloyd's algorithm.
std::vector<Look> centres_of(const std::vector<Look>& samples, int types) {
    if (samples.empty()) return {};
    std::vector<Look> centres = first_centres(samples, types);
    for (int round = 0; round < kRounds; ++round) {
        std::vector<std::array<double, kLooks>> sums(centres.size());
        std::vector<double> counts(centres.size());
        for (const Look& look : samples) {
            const std::size_t i = nearest(centres, look);
            counts[i] += 1.0;
            for (std::size_t k = 0; k < kLooks; ++k)
                sums[i][k] += static_cast<double>(look[k]);
        }
        for (std::size_t i = 0; i < centres.size(); ++i)
            for (std::size_t k = 0; k < kLooks && counts[i] > 0.0; ++k)
                centres[i][k] = static_cast<float>(sums[i][k] / counts[i]);
    }
    std::ranges::stable_sort(centres, {}, ruggedness);
    return centres;
}

// The most common type of the blocks around, and of equally common ones the calmer.
Field<std::uint8_t> majority(const Field<std::uint8_t>& types, int count) {
    Field<std::uint8_t> result(types.width(), types.height());
    Field<float> most(types.width(), types.height());
    for (int type = 0; type < count; ++type) {
        Field<float> is(types.width(), types.height());
        std::ranges::transform(types, is.begin(),
                               [&](std::uint8_t t) { return t == type ? 1.0f : 0.0f; });
        const WindowSums sums(is);
        parallel_for(types.height(), 16, [&](int y) {
            for (int x = 0; x < types.width(); ++x) {
                const float share = static_cast<float>(sums.mean(x, y, kMajority));
                if (share <= most(x, y)) continue;
                most(x, y) = share;
                result(x, y) = static_cast<std::uint8_t>(type);
            }
        });
    }
    return result;
}

struct Kinds {
    int first = 0;  // type of the first centre; water, if it is a type, has 0
    std::vector<Look> centres;
};

Kinds kinds_of(const std::vector<Looks>& all, int types) {
    std::size_t blocks = 0;
    for (const Looks& looks : all) blocks += looks.numbers.size();
    const double water = 1.0 - double(land_of(all)) / double(blocks);
    const int first = types > 1 && water > kMuchWater ? 1 : 0;
    return {first, centres_of(samples_of(all), types - first)};
}

Field<std::uint8_t> types_of(const Looks& looks, const Kinds& kinds,
                             const Field<float>& land, int types) {
    Field<std::uint8_t> blocks(looks.level.width(), looks.level.height());
    parallel_for(blocks.height(), 4, [&](int y) {
        for (int x = 0; x < blocks.width(); ++x)
            if (!looks.level(x, y))
                blocks(x, y) = static_cast<std::uint8_t>(
                    std::size_t(kinds.first) +
                    nearest(kinds.centres, looks.numbers(x, y)));
    });
    blocks = majority(blocks, types);
    Field<std::uint8_t> result(land.width(), land.height());
    for (int y = 0; y < land.height(); ++y)
        for (int x = 0; x < land.width(); ++x)
            result(x, y) = blocks(x / kBlock, y / kBlock);
    return result;
}

}  // namespace

std::vector<Field<std::uint8_t>> automatic_types(std::span<const Field<float>> heights,
                                                 double spacing, int types) {
    assert(types > 0 && spacing > 0.0);
    std::vector<Looks> all;
    for (const Field<float>& land : heights) all.push_back(looks_of(land, spacing));
    if (all.empty()) return {};
    standardise(all);
    const Kinds kinds = kinds_of(all, types);
    std::vector<Field<std::uint8_t>> result;
    for (std::size_t i = 0; i < all.size(); ++i)
        result.push_back(types_of(all[i], kinds, heights[i], types));
    return result;
}

}  // namespace cydonia::texture
