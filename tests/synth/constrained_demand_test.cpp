#include "synth/pareidolia/constrained/demand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

Demand demand_of(Field<Part> parts, double azimuth_degrees, float light, float crisp) {
    const int width = parts.width(), height = parts.height();
    return {{radians(azimuth_degrees), radians(25.0)}, std::move(parts),
            Field<float>(width, height, 3.0f),         Field<float>(width, height, light),
            Field<float>(width, height, crisp),        1.0};
}

Field<Part> random_parts(int width, int height, std::uint64_t seed) {
    Field<Part> parts(width, height);
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i] = static_cast<Part>(hash_of({seed, i / 2}) % 4);
    return parts;
}

const double kFall = 10.0 * std::tan(radians(25.0));  // metres a cell of 10 m

}  // namespace

TEST(Demand, ShadowsHaveACasterAndFreeGroundALitOneAfterIt) {
    for (const double azimuth : {0.0, 90.0, 17.0, 135.0, 215.0, 305.0})
        for (const Stops stops : {Stops::kColumns, Stops::kEveryEdge})
            for (std::uint64_t seed = 0; seed < 10; ++seed) {
                const LightRows rows(23, 17, radians(azimuth), stops);
                const Records records =
                    records_of(demand_of(random_parts(46, 34, seed), azimuth, 0.1f, 0.2f),
                               rows, 2.0, 10.0);
                for (int row = 0; row < rows.rows(); ++row) {
                    const auto [first, past] = rows.span(row);
                    bool lit = false;
                    for (int i = first; i < past; ++i) {
                        lit |= records.parts(i, row) == Part::kLit;
                        if (records.parts(i, row) == Part::kShadow) {
                            EXPECT_TRUE(lit);
                        }
                        if (!rows.counts(i)) {
                            EXPECT_EQ(records.parts(i, row), Part::kAny);
                        }
                    }
                    lit = false;
                    for (int i = past - 1; i >= first; --i) {
                        lit |= records.parts(i, row) == Part::kLit;
                        if (records.parts(i, row) == Part::kFree) {
                            EXPECT_TRUE(lit);
                        }
                    }
                }
            }
}

TEST(Demand, LightRisesWithTheWayButForItsMargin) {
    for (const double azimuth : {90.0, 0.0, 35.0}) {
        const LightRows rows(20, 20, radians(azimuth), Stops::kColumns);
        const Records records =
            records_of(demand_of(Field<Part>(20, 20, Part::kLit), azimuth, 0.15f, 0.25f),
                       rows, 1.0, 10.0);
        const int row = rows.rows() / 2;
        const auto [first, past] = rows.span(row);
        ASSERT_GT(past - first, 5);
        for (int i = first + 1; i < past; ++i)
            EXPECT_NEAR(records.offsets(i, row) - records.offsets(i - 1, row),
                        (1.0 - 0.15) * kFall * rows.step(), 1e-3)
                << azimuth;
    }
}

TEST(Demand, ACoarseCellIsAsManyMetresWide) {
    const LightRows rows(10, 10, radians(90.0), Stops::kColumns);
    const Records records = records_of(
        demand_of(Field<Part>(20, 20, Part::kLit), 90.0, 0.0f, 0.0f), rows, 2.0, 20.0);
    EXPECT_NEAR(records.offsets(5, 5) - records.offsets(4, 5), 2.0 * kFall, 1e-3);
}

// From the east, on a row of 12 cells: light comes in at cell 11.
TEST(Demand, ShadowLiesBelowItsCasterAndEndsCrisply) {
    Field<Part> parts(12, 3, Part::kLit);
    for (int x = 4; x < 8; ++x) parts(x, 1) = Part::kShadow;
    const LightRows rows(12, 3, radians(90.0), Stops::kColumns);
    const Records records =
        records_of(demand_of(std::move(parts), 90.0, 0.0f, 0.25f), rows, 1.0, 10.0);
    int row = 0;
    while (rows.position(0.0, row).y != 1.0) ++row;
    // Samples 0 to 3 are lit, 4 to 7 in shadow, three cells inside; then light again.
    EXPECT_EQ(records.parts(3, row), Part::kLit);
    EXPECT_EQ(records.parts(4, row), Part::kShadow);
    EXPECT_EQ(records.parts(8, row), Part::kLit);
    EXPECT_NEAR(records.offsets(4, row) - records.offsets(3, row),
                kFall + 0.25 * 2.5 * kFall, 1e-3);
    EXPECT_NEAR(records.offsets(8, row) - records.offsets(3, row),
                5.0 * kFall - 0.25 * kFall, 1e-3);
    EXPECT_GT(records.depths(4, row), 0.0f);
    EXPECT_LT(records.depths(4, row), 2.0 * kFall);
}

TEST(Demand, DepthIsFreeWhereItIsAskedForWithoutBound) {
    const LightRows rows(12, 3, radians(90.0), Stops::kColumns);
    Demand demand = demand_of(Field<Part>(12, 3, Part::kShadow), 90.0, 0.0f, 0.25f);
    demand.depth = 1e6;
    const Records records = records_of(demand, rows, 1.0, 10.0);
    EXPECT_EQ(records.parts(0, 0), Part::kLit);  // the land's own edge casts it
    EXPECT_GT(records.depths(5, 0), 1e5f);
}
