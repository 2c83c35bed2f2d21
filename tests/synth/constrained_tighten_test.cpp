#include "synth/pareidolia/constrained/tighten.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/synth/constrained_fields.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

// A box of shadow [8, 14) x [6, 12) in lit ground, the outermost cells free.
Demand demand_of(double azimuth_degrees) {
    Demand demand{{radians(azimuth_degrees), radians(25.0)},
                  Field<Part>(22, 18, Part::kLit),
                  Field<float>(22, 18),
                  Field<float>(22, 18, 0.1f),
                  Field<float>(22, 18, 0.2f),
                  1.0};
    for (int y = 0; y < 18; ++y)
        for (int x = 0; x < 22; ++x) {
            if (x == 0 || y == 0 || x == 21 || y == 17)
                demand.parts(x, y) = Part::kFree;
            else if (x >= 8 && x < 14 && y >= 6 && y < 12)
                demand.parts(x, y) = Part::kShadow;
        }
    return demand;
}

// What is asked for, at 2x2 samples a cell.
Field<std::uint8_t> perfect(const Demand& demand) {
    Field<std::uint8_t> cast(44, 36);
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 44; ++x)
            cast(x, y) = demand.parts(x / 2, y / 2) == Part::kShadow;
    return cast;
}

void set_cell(Field<std::uint8_t>& cast, int x, int y, std::uint8_t value) {
    draw_box(cast, 2 * x, 2 * y, 2 * x + 2, 2 * y + 2, value);
}

}  // namespace

TEST(Wrong, CountsSamplesOfBothKinds) {
    const Demand demand = demand_of(90.0);
    auto cast = perfect(demand);
    EXPECT_EQ(wrong_in(demand, cast).all(), 0u);
    set_cell(cast, 10, 8, 0);
    cast(6, 6) = 1;
    EXPECT_EQ(wrong_in(demand, cast).lit, 4u);
    EXPECT_EQ(wrong_in(demand, cast).dark, 1u);
    EXPECT_EQ(wrong_in(demand, cast).all(), 5u);
}

TEST(Wrong, FreeCellsMayBeEither) {
    const Demand demand = demand_of(90.0);
    auto cast = perfect(demand);
    set_cell(cast, 0, 5, 1);
    EXPECT_EQ(wrong_in(demand, cast).all(), 0u);
}

TEST(Tighten, WhatIsRightStays) {
    const Demand before = demand_of(90.0);
    Demand after = before;
    tighten(after, perfect(before));
    EXPECT_EQ(after.light, before.light);
    EXPECT_EQ(after.crisp, before.crisp);
}

TEST(Tighten, LightIsWidenedAroundDarkGround) {
    const Demand before = demand_of(90.0);
    Demand after = before;
    auto cast = perfect(before);
    set_cell(cast, 4, 14, 1);
    tighten(after, cast);
    EXPECT_EQ(after.crisp, before.crisp);
    for (int y = 0; y < 18; ++y)
        for (int x = 0; x < 22; ++x) {
            const bool around = std::abs(x - 4) <= 1 && std::abs(y - 14) <= 1;
            EXPECT_EQ(after.light(x, y) > before.light(x, y), around) << x << ", " << y;
        }
}

TEST(Tighten, ShadowIsWidenedAroundLitOnes) {
    const Demand before = demand_of(90.0);
    Demand after = before;
    auto cast = perfect(before);
    set_cell(cast, 10, 8, 0);
    tighten(after, cast);
    EXPECT_EQ(after.light, before.light);
    for (int y = 0; y < 18; ++y)
        for (int x = 0; x < 22; ++x) {
            const bool around = std::abs(x - 10) <= 1 && std::abs(y - 8) <= 1;
            EXPECT_EQ(after.crisp(x, y) > before.crisp(x, y), around) << x << ", " << y;
        }
}

TEST(Tighten, MoreWhereMoreIsWrong) {
    const Demand before = demand_of(90.0);
    Demand after = before;
    auto cast = perfect(before);
    set_cell(cast, 4, 14, 1);
    cast(8, 4) = 1;  // a quarter of cell (4, 2)
    tighten(after, cast);
    EXPECT_NEAR(after.light(4, 14) - 0.1f, 4.0f * (after.light(4, 2) - 0.1f), 1e-6);
}

// A crest is dark beyond its own sample, and margins along a shadow's side add up to a
// cliff: beside shadow none mends what is dark. Two cells from it one does.
TEST(Tighten, CellsBesideShadowAreForgiven) {
    struct Side {
        int x, y, away_x, away_y;
    };
    for (const double azimuth : {90.0, 215.0})
        for (const auto& [x, y, away_x, away_y] :
             {Side{14, 8, 1, 0}, {7, 8, -1, 0}, {10, 5, 0, -1}, {10, 12, 0, 1}}) {
            const Demand before = demand_of(azimuth);
            Demand after = before;
            auto cast = perfect(before);
            set_cell(cast, x, y, 1);
            tighten(after, cast);
            EXPECT_EQ(after.light, before.light) << x << ", " << y;
            set_cell(cast, x + away_x, y + away_y, 1);
            tighten(after, cast);
            EXPECT_GT(after.light(x + away_x, y + away_y), 0.1f) << x << ", " << y;
        }
}

TEST(Tighten, ComesToAnEnd) {
    Demand demand = demand_of(90.0);
    demand.light(3, 14) = 2.0f;  // wide from the beginning: stays
    auto cast = perfect(demand);
    set_cell(cast, 4, 14, 1);
    set_cell(cast, 10, 8, 0);
    for (int round = 0; round < 50; ++round) tighten(demand, cast);
    EXPECT_LE(demand.light(4, 14), 1.0f);
    EXPECT_LE(demand.crisp(10, 8), 1.0f);
    EXPECT_EQ(demand.light(3, 14), 2.0f);
}
