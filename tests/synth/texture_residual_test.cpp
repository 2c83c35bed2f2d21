#include "synth/texture/constraints/residual.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

#include "field/random.h"
#include "synth/texture/constraints/constraint_errors.h"

namespace cydonia::texture {
namespace {

using namespace geometry;

constexpr double kCell = 10.0;
constexpr Ground kGround{1280.0, 960.0, kCell};
constexpr int kWidth = 128, kHeight = 96;

Place2 place(double x, double y) { return {metres(x), metres(y)}; }

// A curve over most of the terrain, 300 m high, and a point.
Geometry constraints(std::vector<Place2> points, bool with_point = false) {
    Options options;
    Curve c;
    c.name = "curve";
    c.points = std::move(points);
    c.height = 300.0;
    options.curves.push_back(c);
    if (with_point) {
        Point p;
        p.name = "point";
        p.at = place(203, 807);
        p.height = -120.0;
        options.points.push_back(p);
    }
    SilentProgress progress;
    return {options, kGround, [](double, double) { return 0.0; }, progress};
}

Geometry wave() {
    return constraints(
        {place(150, 300), place(500, 700), place(800, 250), place(1100, 600)}, true);
}

Field<float> corrected(const Geometry& geometry, Field<float> heights, int times) {
    const auto pulls = geometry.pulls({0, 0, 0, heights.width(), heights.height()});
    for (int k = 0; k < times; ++k) {
        const auto correction = residual_correction(pulls, heights, kCell);
        for (std::size_t i = 0; i < heights.size(); ++i) heights[i] += correction[i];
    }
    return heights;
}

double steepest(const Field<float>& heights) {
    double worst = 0.0;
    for (int y = 1; y < heights.height(); ++y)
        for (int x = 1; x < heights.width(); ++x)
            worst = std::max({worst, std::abs(double(heights(x, y)) - heights(x - 1, y)),
                              std::abs(double(heights(x, y)) - heights(x, y - 1))});
    return worst / kCell;
}

TEST(TextureResidual, FlatLandComesToACurveWithoutACliff) {
    const Geometry geometry = wave();
    const auto land = corrected(geometry, Field<float>(kWidth, kHeight, 0.0f), 2);
    const ConstraintErrors errors = constraint_errors(geometry, land, kCell);
    ASSERT_EQ(errors.each.size(), 2u);
    EXPECT_LT(errors.all.rms, 0.01 * 300.0);
    EXPECT_LT(errors.each[0].rms, 0.02 * 120.0);
    EXPECT_LT(errors.each[1].rms, 0.01 * 300.0);
    EXPECT_LT(errors.all.max, 0.03 * 300.0);
    EXPECT_LT(steepest(land), 1.6 * 300.0 / (8 * kCell));
}

TEST(TextureResidual, OneLineIsLiftedLikeABell) {
    const Geometry geometry = constraints({place(-300, 485), place(1600, 485)});
    const auto land = corrected(geometry, Field<float>(kWidth, kHeight, 0.0f), 1);
    const int row = 47;  // 485 m north
    for (int d = 0; d <= 8; ++d) {
        const double bell = std::pow(1.0 - d * d / 64.0, 2.0);
        EXPECT_NEAR(land(60, row + d), 300.0 * bell, 12.0) << d;
        EXPECT_NEAR(land(60, row + d), land(60, row - d), 0.01) << d;
    }
    EXPECT_EQ(land(60, row + 9), 0.0f);
    EXPECT_EQ(land(60, row - 9), 0.0f);
}

// A crest that rises and falls by 200 m over 30 cells.
TEST(TextureResidual, ACrestIsFollowedUpAndDown) {
    Options options;
    Curve c;
    c.points = {place(0, 485), place(1200, 485)};
    for (int k = 0; k <= 8; ++k)
        c.handles.push_back({k / 8.0, k % 2 ? 300.0 : 100.0, {}, {}});
    options.curves.push_back(c);
    SilentProgress progress;
    const Geometry geometry(
        options, kGround, [](double, double) { return 0.0; }, progress);
    const auto land = corrected(geometry, Field<float>(kWidth, kHeight, 0.0f), 2);
    EXPECT_LT(constraint_errors(geometry, land, kCell).all.rms, 4.0);
}

// Two lines ten cells apart; by bells alone the land between them bends by 115 m.
TEST(TextureResidual, NoCreaseBetweenTwoLines) {
    Options options;
    for (double y : {405.0, 505.0}) {
        Curve c;
        c.points = {place(-300, y), place(1600, y)};
        c.height = 300.0;
        options.curves.push_back(c);
    }
    SilentProgress progress;
    const Geometry geometry(
        options, kGround, [](double, double) { return 0.0; }, progress);
    const auto land = corrected(geometry, Field<float>(kWidth, kHeight, 0.0f), 1);
    for (int y = 47; y < 55; ++y) {
        const double bend = land(60, y - 1) - 2.0 * land(60, y) + land(60, y + 1);
        EXPECT_LT(std::abs(bend), 45.0) << y;
    }
}

TEST(TextureResidual, RoughnessAlongACrestStays) {
    const Geometry geometry = constraints({place(-300, 485), place(1600, 485)});
    Field<float> rough(kWidth, kHeight, 0.0f);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) rough(x, y) = x % 2 ? 20.0f : -20.0f;
    const auto land = corrected(geometry, rough, 2);
    double step = 0.0, mean = 0.0;
    for (int x = 40; x < 80; ++x) {
        step += std::abs(land(x, 47) - land(x - 1, 47)) / 40.0;
        mean += land(x, 47) / 40.0;
    }
    EXPECT_NEAR(step, 40.0, 4.0);
    EXPECT_NEAR(mean, 300.0, 1.0);
}

TEST(TextureResidual, WhatIsAtItsHeightStays) {
    const Geometry geometry = constraints({place(150, 300), place(1100, 600)});
    const Field<float> land(kWidth, kHeight, 300.0f);
    EXPECT_EQ(corrected(geometry, land, 1), land);
    const Field<float> free(20, 20, 5.0f);
    for (float value : residual_correction({20, 20}, free, kCell)) EXPECT_EQ(value, 0.0f);
}

TEST(TextureResidual, WindowsAndThreadsGiveTheSameBytes) {
    const Geometry geometry = wave();
    Field<float> land(kWidth, kHeight);
    for (std::size_t i = 0; i < land.size(); ++i)
        land[i] = static_cast<float>(50.0 * unit(hash_of({i})));
    const auto pulls = geometry.pulls({0, 0, 0, kWidth, kHeight});
    const auto whole = residual_correction(pulls, land, kCell);

    const int halo = ResidualSpread{}.halo();
    ASSERT_LE(halo, 16);
    const Window part{0, 17, 13, 61, 55};
    Field<float> cut(part.width, part.height);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) cut(x, y) = land(part.x + x, part.y + y);
    const auto alone = residual_correction(geometry.pulls(part), cut, kCell);
    int touched = 0;
    for (int y = halo; y < part.height - halo; ++y)
        for (int x = halo; x < part.width - halo; ++x) {
            ASSERT_EQ(alone(x, y), whole(part.x + x, part.y + y)) << x << ", " << y;
            touched += alone(x, y) != 0.0f;
        }
    EXPECT_GT(touched, 300);

    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(residual_correction(pulls, land, kCell), whole);
}

TEST(TextureConstraintErrors, OfLandThatIsAPlane) {
    const Geometry geometry = constraints({place(100, 400), place(1100, 400)}, true);
    Field<float> land(64, 48);  // at half the resolution
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            land(x, y) = float(300.0 + 0.1 * (20.0 * (x + 0.5) - 600.0));
    const ConstraintErrors errors = constraint_errors(geometry, land, 20.0);
    ASSERT_EQ(errors.each.size(), 2u);
    EXPECT_EQ(errors.each[0].name, "point");
    EXPECT_EQ(errors.each[0].sites, 1);
    EXPECT_NEAR(errors.each[0].max, 420.0 - 39.7, 1e-3);
    EXPECT_NEAR(errors.each[1].max, 50.0, 1e-3);
    EXPECT_NEAR(errors.each[1].rms, 50.0 / std::sqrt(3.0), 0.5);
    EXPECT_EQ(errors.all.sites, errors.each[0].sites + errors.each[1].sites);
    EXPECT_NEAR(errors.all.max, errors.each[0].max, 1e-9);
}

TEST(TextureConstraintErrors, NoLandNoSites) {
    const Geometry geometry = constraints({place(-500, 400), place(-100, 400)});
    const ConstraintErrors errors =
        constraint_errors(geometry, Field<float>(8, 6, 1.0f), 160.0);
    EXPECT_EQ(errors.each[0].sites, 0);
    EXPECT_EQ(errors.each[0].rms, 0.0);
    EXPECT_EQ(errors.all.max, 0.0);
}

}  // namespace
}  // namespace cydonia::texture
