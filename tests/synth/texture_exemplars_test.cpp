#include "synth/texture/database/exemplars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/synth/texture_lands.h"

namespace cydonia::texture {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

double plane_at(double x, double y) { return 500.0 + 3.0 * x + 2.0 * y; }

class Exemplars : public testing::Test {
  protected:
    void add(const std::string& name, Field<float> heights, double spacing = 10.0) {
        options_.exemplars.push_back(
            exemplar_of(folder_, name, std::move(heights), spacing));
    }
    Lands lands() { return lands_of(options_, listener_); }
    void expect_refused(std::string_view words) {
        expect_error(ExitCode::kBadRequest, words, [&] { lands(); });
    }

    const TemporaryFolder folder_;
    Options options_;
    Listener listener_;
};

TEST_F(Exemplars, FirstOnesSpacingAndHeightsAreKept) {
    const Field<float> heights = heights_of(30, 20, plane_at);
    add("a.tif", heights);
    const Lands all = lands();
    EXPECT_EQ(all.spacing, 10.0);
    EXPECT_EQ(all.all.front().heights, heights);
    EXPECT_EQ(all.all.front().name, "a.tif");
    EXPECT_TRUE(all.all.front().voids.empty());
    EXPECT_TRUE(std::ranges::all_of(all.all.front().types,
                                    [](std::uint8_t type) { return type == kNoType; }));
    EXPECT_TRUE(listener_.notes.empty());
}

TEST_F(Exemplars, OthersAreResampledToIt) {
    add("a.tif", rough(30, 20));
    add("b.tif", heights_of(40, 40, plane_at), 25.0);
    const Lands all = lands();
    const Field<float>& b = all.all[1].heights;
    ASSERT_EQ(b.width(), 100);
    // A plane stays that plane; cell (x, y) of 10 m lies at (x + 1/2) 10 / 25 - 1/2.
    for (int y = 10; y < 90; ++y)
        for (int x = 10; x < 90; ++x)
            ASSERT_NEAR(b(x, y), plane_at(0.4 * x - 0.3, 0.4 * y - 0.3), 1e-3);
    ASSERT_EQ(listener_.notes.size(), 1u);
    EXPECT_EQ(listener_.notes[0],
              "b.tif: resampled from cells of 25 m to the synthesis' 10 m");
}

TEST_F(Exemplars, SpacingIsStretchedAndHeightsAreScaled) {
    const Field<float> heights = rough(30, 20);
    add("a.tif", heights);
    options_.scale = 3.0;
    options_.vertical_scale = -0.5;
    const Lands all = lands();
    EXPECT_EQ(all.spacing, 30.0);
    for (std::size_t i = 0; i < heights.size(); ++i)
        ASSERT_EQ(all.all[0].heights[i], -0.5f * heights[i]);
}

TEST_F(Exemplars, GivenSpacing) {
    add("a.tif", heights_of(120, 80, plane_at));
    options_.spacing = 20.0;
    options_.scale = 0.5;
    const Lands all = lands();
    EXPECT_EQ(all.spacing, 20.0);
    EXPECT_EQ(all.all[0].heights.width(), 30);
    EXPECT_NEAR(all.all[0].heights(7, 5), plane_at(29.5, 21.5), 1e-3);
}

TEST_F(Exemplars, VoidsAreKnownWhereverTheyMoved) {
    Field<float> heights = rough(60, 60);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 40; ++x) heights(x, y) = kNan;
    add("a.tif", heights);
    options_.spacing = 5.0;
    const Land land = lands().all[0];
    ASSERT_TRUE(land.voids.same_shape(land.heights));
    EXPECT_EQ(land.voids(70, 60), 1);
    EXPECT_EQ(land.voids(85, 60), 0);
    EXPECT_TRUE(
        std::ranges::all_of(land.heights, [](float h) { return std::isfinite(h); }));
}

TEST_F(Exemplars, NoneAtAll) { expect_refused("no exemplars"); }

TEST_F(Exemplars, SmallerThanANeighbourhood) {
    add("small.tif", rough(10, 40));
    expect_refused("small.tif: 10 x 40 cells of 10 m: an exemplar needs 11 x 11");
    options_.exemplars.clear();
    add("enough.tif", rough(11, 11));
    EXPECT_EQ(lands().all.size(), 1u);
    options_.spacing = 20.0;
    expect_refused("enough.tif: 5 x 5 cells");
}

TEST_F(Exemplars, ConstantHeight) {
    add("flat.tif", Field<float>(30, 30, 7.5f));
    expect_refused("flat.tif: all its heights are 7.5 m");
}

TEST_F(Exemplars, HeightsThatAreNoLand) {
    add("a.tif", rough(30, 30));
    options_.vertical_scale = 1e300;
    expect_refused("a.tif: its heights go from -inf to inf m, which no land does");
    options_.vertical_scale = 1e-300;
    expect_refused("a.tif: all its heights are 0 m");
}

TEST_F(Exemplars, AllVoid) {
    add("void.tif", Field<float>(30, 30, kNan));
    expect_refused("void.tif");
}

TEST_F(Exemplars, TooManyCells) {
    add("a.tif", rough(30, 30));
    options_.spacing = 0.01;
    expect_refused("a.tif: 30000 x 30000 cells of 0.01 m, more than 16384 x 16384");
    options_.spacing = 1e-300;
    expect_refused("a.tif: ");
    options_.spacing = 1e300;
    expect_refused("a.tif: ");
}

}  // namespace
}  // namespace cydonia::texture
