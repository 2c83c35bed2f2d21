#include "synth/distance/regions.h"

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "synth/distance/layout.h"
#include "tests/synth/distance_land.h"

namespace cydonia::distance {
namespace {

// Black where dark(x, y), white elsewhere.
template <class Dark>
Field<Rgb8> drawing(int side, const Dark& dark) {
    Field<Rgb8> pixels(side, side, kWhite);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            if (dark(x, y)) pixels(x, y) = kBlack;
    return pixels;
}

Field<Rgb8> ring(int side, double radius) {
    return drawing(side, [&](int x, int y) {
        return std::abs(std::hypot(x - side / 2, y - side / 2) - radius) < 1.0;
    });
}

Profile straight(const std::string& name, double reach) {
    Profile profile;
    profile.name = name;
    profile.curve.points = {{0, 1}, {1, 0}};
    profile.reach = metres(reach);
    return profile;
}

// A rim 400 m above the sea, on weights without chance.
Options rim(const Source& strokes) {
    Options options;
    options.groups.resize(1);
    options.groups[0].name = "rim";
    options.groups[0].where = Strokes{strokes, {}};
    set_range(options, 100.0, 100.0);
    options.sea_level_scale = 5.0;
    options.edge_weight_deviation = 0.0;
    options.sea_level_threshold = metres(0.1);
    options.groups[0].profile = {"outside"};
    options.profiles = {straight("outside", 1000.0), straight("inside", 4000.0)};
    return options;
}

TEST(Region, ItsProfileHoldsInside) {
    const Picture strokes(ring(128, 24.0));
    Options options = rim(strokes.source());
    RegionOptions region;
    region.inside = "rim";
    region.profile = "inside";
    options.regions = {region};
    const Field<float> heights = land(options, flat(128, 128, 1280.0)).heights;
    // The rim's slope is 500 m over the reach, whatever its height.
    const float top = heights(64 + 24, 64);
    EXPECT_NEAR(top, 400.0f, 1.0f);
    EXPECT_NEAR(heights(64 + 14, 64), top - 100.0f * 500.0f / 4000.0f, 4.0f);
    EXPECT_NEAR(heights(64 + 34, 64), top - 100.0f * 500.0f / 1000.0f, 8.0f);
}

TEST(Region, OnlyItsGroupsBlendThere) {
    const Picture strokes(ring(128, 30.0));
    // A higher peak in the middle of the ring.
    const Picture peak(
        drawing(128, [](int x, int y) { return std::hypot(x - 64, y - 64) < 1.0; }));
    Options options = rim(strokes.source());
    options.groups.push_back(options.groups[0]);
    options.groups[1].name = "peak";
    options.groups[1].where = Strokes{peak.source(), {}};
    options.groups[1].cost.range = {{metres(0.0), metres(0.0)}};
    EXPECT_GT(land(options, flat(128, 128, 1280.0)).heights(64, 64), 450.0f);

    RegionOptions region;
    region.inside = "rim";
    region.only = {"rim"};
    options.regions = {region};
    const Field<float> heights = land(options, flat(128, 128, 1280.0)).heights;
    options.groups.pop_back();
    const Field<float> alone = land(options, flat(128, 128, 1280.0)).heights;
    for (int x = 44; x < 84; ++x) EXPECT_NEAR(heights(x, 64), alone(x, 64), 1e-2f) << x;
    EXPECT_GT(heights(64, 64), 100.0f);
}

TEST(Region, TheLaterHoldsWhereTwoOverlap) {
    const Picture strokes(ring(64, 12.0));
    const Picture west(drawing(64, [](int x, int) { return x < 40; }));
    const Picture east(drawing(64, [](int x, int) { return x >= 24; }));
    Options options = rim(strokes.source());
    options.regions.resize(2);
    options.regions[0].image = west.source();
    options.regions[0].profile = "outside";
    options.regions[1].image = east.source();
    options.regions[1].profile = "inside";
    const Layout layout = layout_of(options, flat(64, 64), 1);
    const auto profile = [&](int x) {
        return layout.regions.profile_at[layout.graph.node(x, 30)];
    };
    EXPECT_EQ(profile(10), 0);
    EXPECT_EQ(profile(30), 1);
    EXPECT_EQ(profile(50), 1);
}

TEST(Region, InsideIsWhatClosedStrokesEnclose) {
    const Picture strokes(ring(64, 20.0));
    const Layout layout = layout_of(rim(strokes.source()), flat(64, 64), 1);
    const Field<std::uint8_t> inside = enclosed(layout.graph, layout.features, 0);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double r = std::hypot(x - 32, y - 32);
            if (r < 18.5) {
                EXPECT_EQ(inside(x, y), 1);
            } else if (r > 19.5) {
                EXPECT_EQ(inside(x, y), 0);
            }
        }
    }
}

TEST(Region, AnOpenStrokeEnclosesNothing) {
    const Picture stroke(drawing(64, [](int x, int y) { return y == 30 && x > 10; }));
    Options options = rim(stroke.source());
    RegionOptions region;
    region.inside = "rim";
    options.regions = {region};
    try {
        land(options, flat(64, 64));
        FAIL() << "a region inside nothing";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("'rim' enclose nothing"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace cydonia::distance
