#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "synth/pareidolia/constrained/records.h"
#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

// h[above] + offset[above] - h[below] - offset[below] >= at_least.
struct Inequality {
    int above, below;
    double at_least;
};

struct Row {
    Records records;
    std::vector<float> heights;
};

// What records.h says, pair by pair.
std::vector<Inequality> inequalities(const Records& records) {
    const int n = records.parts.width();
    const auto lit = [&](int i, int step) {
        for (i += step; i >= 0 && i < n; i += step)
            if (records.parts(i, 0) == Part::kLit) return i;
        return -1;
    };
    std::vector<Inequality> result;
    const auto add = [&](int above, int below, double margin) {
        result.push_back(
            {above, below,
             margin + double(records.offsets(below, 0)) - records.offsets(above, 0)});
    };
    for (int i = 0; i < n; ++i) {
        const int before = lit(i, -1), after = lit(i, 1);
        if (records.parts(i, 0) == Part::kLit && before >= 0) add(i, before, 0.0);
        if (records.parts(i, 0) == Part::kShadow) {
            add(before, i, 0.0);
            add(i, before, -double(records.depths(i, 0)));
        }
        if (records.parts(i, 0) == Part::kFree) add(after, i, 0.0);
    }
    return result;
}

// Hildreth 1957: ascent of the dual, one inequality at a time.
std::vector<double> slowly_projected(const Row& row) {
    const std::vector<Inequality> all = inequalities(row.records);
    std::vector<double> x(row.heights.begin(), row.heights.end());
    std::vector<double> price(all.size());
    for (int sweep = 0; sweep < 20000; ++sweep) {
        double moved = 0.0;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const auto& [above, below, at_least] = all[k];
            const double lacks = (at_least - (x[above] - x[below])) / 2.0;
            const double more = std::max(-price[k], lacks);
            price[k] += more;
            x[above] += more;
            x[below] -= more;
            moved = std::max(moved, std::abs(more));
        }
        if (moved < 1e-10) break;
    }
    return x;
}

// All parts, some depths 0 and some beyond reach, ties, runs of one kind.
Row random_row(int n, std::uint64_t seed) {
    const auto draw = [&](const char* what, int i) {
        return hash_of({seed, key(what), std::uint64_t(i)});
    };
    Row row{{Field<Part>(n, 1), Field<float>(n, 1), Field<float>(n, 1)},
            std::vector<float>(static_cast<std::size_t>(n))};
    const bool tied = draw("tied", 0) % 3 == 0;
    const std::uint64_t kinds = 2 + draw("kinds", 0) % 3;
    Part part = Part::kLit;
    for (int i = 0; i < n; ++i) {
        constexpr Part kParts[] = {Part::kLit, Part::kShadow, Part::kFree, Part::kAny};
        if (draw("change", i) % 2) part = kParts[draw("part", i) % kinds];
        row.records.parts(i, 0) = part;
        const double offset = signed_unit(draw("offset", i));
        row.records.offsets(i, 0) = static_cast<float>(tied ? 0.0 : offset);
        const double depth = unit(draw("depth", i));
        row.records.depths(i, 0) = static_cast<float>(depth < 0.2   ? 0.0
                                                      : depth > 0.8 ? 1e6
                                                                    : depth);
        const double height = 2.0 * signed_unit(draw("height", i));
        row.heights[static_cast<std::size_t>(i)] =
            static_cast<float>(tied ? std::round(2.0 * height) : height);
    }
    // What nothing can cast, or nothing keeps down, is for demands to see to.
    bool lit = false;
    for (int i = 0; i < n; ++i) {
        lit |= row.records.parts(i, 0) == Part::kLit;
        if (!lit && row.records.parts(i, 0) == Part::kShadow)
            row.records.parts(i, 0) = Part::kAny;
    }
    lit = false;
    for (int i = n - 1; i >= 0; --i) {
        lit |= row.records.parts(i, 0) == Part::kLit;
        if (!lit && row.records.parts(i, 0) == Part::kFree)
            row.records.parts(i, 0) = Part::kAny;
    }
    return row;
}

std::vector<float> projected(const Row& row) {
    std::vector<float> heights = row.heights;
    RecordsProjection()(row.records, 0, 0, static_cast<int>(heights.size()),
                        heights.data());
    return heights;
}

void expect_obeyed(const Row& row, const std::vector<float>& heights, double tolerance) {
    for (const auto& [above, below, at_least] : inequalities(row.records))
        EXPECT_GE(double(heights[above]) - heights[below], at_least - tolerance)
            << above << " above " << below;
}

}  // namespace

TEST(RecordsProjection, ObeysEveryInequality) {
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const Row row = random_row(1 + static_cast<int>(seed % 120), seed);
        expect_obeyed(row, projected(row), 1e-5);
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
}

TEST(RecordsProjection, FindsTheNearestHeights) {
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        const Row row = random_row(1 + static_cast<int>(seed % 20), seed);
        const std::vector<double> slow = slowly_projected(row);
        const std::vector<float> fast = projected(row);
        for (std::size_t i = 0; i < fast.size(); ++i)
            ASSERT_NEAR(fast[i], slow[i], 2e-5) << "seed " << seed << ", sample " << i;
    }
}

TEST(RecordsProjection, LeavesWhatObeysAsItIs) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        Row row = random_row(1 + static_cast<int>(seed % 60), seed);
        row.heights = projected(row);
        const std::vector<float> again = projected(row);
        for (std::size_t i = 0; i < again.size(); ++i)
            ASSERT_NEAR(again[i], row.heights[i], 1e-5) << "seed " << seed;
    }
}

TEST(RecordsProjection, OneObjectForManyRowsRemembersNothing) {
    RecordsProjection project;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Row row = random_row(1 + static_cast<int>(seed % 40), seed);
        std::vector<float> heights = row.heights;
        project(row.records, 0, 0, static_cast<int>(heights.size()), heights.data());
        ASSERT_EQ(heights, projected(row)) << "seed " << seed;
    }
}

TEST(RecordsProjection, TouchesOnlyItsSamples) {
    Row row = random_row(30, 4);
    for (Part& part : row.records.parts) part = Part::kLit;
    std::vector<float> heights = row.heights;
    RecordsProjection()(row.records, 0, 10, 20, heights.data());
    for (std::size_t i = 0; i < 30; ++i)
        if (i < 10 || i >= 20) {
            EXPECT_EQ(heights[i], row.heights[i]);
        }
    EXPECT_NE(heights, row.heights);
}

TEST(RecordsProjection, LitGroundAloneIsIsotonicRegression) {
    Row row{{Field<Part>(4, 1, Part::kLit), Field<float>(4, 1), Field<float>(4, 1)},
            {1.0f, 4.0f, 2.0f, 3.0f}};
    EXPECT_EQ(projected(row), (std::vector<float>{1.0f, 3.0f, 3.0f, 3.0f}));
}

TEST(RecordsProjection, AShadowPullsItsCasterUp) {
    Row row{{Field<Part>(2, 1), Field<float>(2, 1), Field<float>(2, 1, 1e6f)},
            {0.0f, 2.0f}};
    row.records.parts(0, 0) = Part::kLit;
    row.records.parts(1, 0) = Part::kShadow;
    EXPECT_EQ(projected(row), (std::vector<float>{1.0f, 1.0f}));
    row.heights = {2.0f, 0.0f};
    EXPECT_EQ(projected(row), row.heights);
    row.records.depths(1, 0) = 1.0f;  // no deeper than this
    EXPECT_EQ(projected(row), (std::vector<float>{1.5f, 0.5f}));
}

TEST(RecordsProjection, WithoutLitGroundNothingIsAsked) {
    Row row{{Field<Part>(3, 1, Part::kAny), Field<float>(3, 1), Field<float>(3, 1)},
            {3.0f, 1.0f, 2.0f}};
    EXPECT_EQ(projected(row), row.heights);
    row.records.parts = Field<Part>(3, 1, Part::kFree);
    EXPECT_EQ(projected(row), row.heights);
}
