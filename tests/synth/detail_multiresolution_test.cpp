#include "synth/detail/multiresolution.h"

#include <gtest/gtest.h>

#include <cmath>

#include "field/noise.h"
#include "field/random.h"

namespace cydonia::detail {
namespace {

constexpr Filter kFilters[] = {Filter::kChaikin, Filter::kHaar, Filter::kFaber,
                               Filter::kCubic};

Field<float> random_land(int width, int height, std::uint64_t seed) {
    Field<float> land(width, height);
    for (std::size_t i = 0; i < land.size(); ++i)
        land[i] = static_cast<float>(1000.0 * signed_unit(hash_of({seed, i})));
    return land;
}

Field<float> put_together(const std::vector<Level>& levels, Filter filter) {
    Field<float> land = levels.back().coarse;
    for (std::size_t i = levels.size(); i-- > 0;)
        land = subdivided(land, levels[i].details, filter);
    return land;
}

double largest(const Field<float>& field) {
    double most = 0.0;
    for (const float v : field) most = std::max(most, std::abs(double(v)));
    return most;
}

// Random sizes and levels: what is taken apart is put together again.
TEST(Multiresolution, IsExactForAnySize) {
    for (std::uint64_t i = 0; i < 60; ++i) {
        const Filter filter = kFilters[i % 4];
        const int width = 4 + int(hash_of({i, 1}) % 510),
                  height = 4 + int(hash_of({i, 2}) % 510);
        const int levels = 1 + int(hash_of({i, 3}) % 4);
        const Field<float> land = random_land(width, height, i);
        const Field<float> whole = padded(land, divisible(filter, width, levels),
                                          divisible(filter, height, levels));
        const std::vector<Level> parts = decomposed(whole, filter, levels);
        const Field<float> again = put_together(parts, filter);
        ASSERT_TRUE(again.same_shape(whole)) << width << "x" << height;
        double most = 0.0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                most = std::max(most, std::abs(double(again(x, y)) - land(x, y)));
        ASSERT_LT(most, 1e-5 * 1000.0)
            << int(filter) << " " << width << "x" << height << ", " << levels;
    }
}

// A P = 1 and B P = 0: land made by subdivision has no details, and its coarse land is
// the one that it was made of.
TEST(Multiresolution, SubdivisionIsReversed) {
    for (const Filter filter : kFilters) {
        const Field<float> coarse = random_land(23, 17, 5);
        const Field<float> fine = subdivided(coarse, no_details(filter, 23, 17), filter);
        const std::vector<Level> parts = decomposed(fine, filter, 1);
        for (std::size_t i = 0; i < coarse.size(); ++i)
            ASSERT_NEAR(parts[0].coarse[i], coarse[i], 2e-3) << int(filter);
        EXPECT_LT(largest(parts[0].details.columns), 2e-3) << int(filter);
        EXPECT_LT(largest(parts[0].details.rows), 2e-3) << int(filter);
    }
}

// The published filters (docs/papers.md, Brosz 2007, 1), inside and at an end.
TEST(Multiresolution, ChaikinsFiltersAreThePublishedOnes) {
    const FilterBank bank = filter_bank(Filter::kChaikin, 20);
    EXPECT_EQ(bank.fine, 38);
    EXPECT_EQ(bank.details, 18);
    const auto weights = [](const Stencil& s) {
        std::vector<float> result;
        for (int i = 0; i < s.count; ++i)
            result.push_back(4.0f * s.taps[std::size_t(i)].weight);
        return result;
    };
    EXPECT_EQ(weights(bank.a[7]), (std::vector<float>{-1, 3, 3, -1}));
    EXPECT_EQ(bank.a[7].taps[0].index, 12);
    EXPECT_EQ(weights(bank.a[0]), (std::vector<float>{4}));
    EXPECT_EQ(weights(bank.pq[12]), (std::vector<float>{3, 1, 3, -1}));
}

// 20, 38, 74, 146: the paper's first trial.
TEST(Multiresolution, SizesAreThePapers) {
    EXPECT_EQ(divisible(Filter::kChaikin, 146, 3), 146);
    EXPECT_EQ(coarser(Filter::kChaikin, 146), 74);
    EXPECT_EQ(coarser(Filter::kChaikin, 38), 20);
    EXPECT_EQ(divisible(Filter::kChaikin, 147, 3), 154);
}

// Smooth land keeps its form when its finest level is dropped; a step does not.
TEST(Multiresolution, SmoothLandHasSmallDetails) {
    for (const Filter filter : {Filter::kChaikin, Filter::kFaber, Filter::kCubic}) {
        const int n = divisible(filter, 130, 1);
        Field<float> smooth(n, n);
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                smooth(x, y) = float(100.0 * std::sin(x / 20.0) * std::cos(y / 25.0));
        const std::vector<Level> parts = decomposed(smooth, filter, 1);
        // The ends have filters of their own, which see slopes.
        const auto inside = [](const Field<float>& details) {
            double most = 0.0;
            for (int y = 2; y < details.height() - 2; ++y)
                for (int x = 2; x < details.width() - 2; ++x)
                    most = std::max(most, std::abs(double(details(x, y))));
            return most;
        };
        EXPECT_LT(inside(parts[0].details.columns), 0.3) << int(filter);
        EXPECT_LT(inside(parts[0].details.rows), 0.3) << int(filter);
    }
}

}  // namespace
}  // namespace cydonia::detail
