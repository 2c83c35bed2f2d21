#include "synth/distance/pass_memory.h"

#include <algorithm>
#include <string>

#include "synth/distance/blend.h"
#include "synth/distance/layout.h"
#include "tests/synth/distance_land.h"

namespace cydonia::distance {
namespace {

struct Made {
    Field<float> heights;
    PassCounts counts;
    std::string remembered;
};

Made made(const Options& options, const std::string& remembered) {
    const Layout layout = layout_of(options, flat(160, 160), 1);
    const Ground ground = layout.ground();
    PassMemory memory(ground, layout.halting, remembered);
    SilentProgress silent;
    Made result;
    result.heights = blended_heights(ground, layout.halting, {options.blending_bias, {}},
                                     approximate_heights(ground, layout.halting), silent,
                                     {&memory, nullptr}, &result.counts);
    result.remembered = memory.taken_bytes();
    return result;
}

// Thirty random peaks and one that `x` moves, all of one cost.
Options with_peak_at(const Picture& stroke) {
    Options options = peaks(30);
    set_range(options, 50.0, 50.0);
    options = shaped(options, {{0, 1}, {10, 0.6}, {30, 0}});
    options.groups.push_back(options.groups[0]);
    options.groups[1].name = "stroke";
    options.groups[1].where = Strokes{stroke.source(), {}};
    options.sea_level_scale = 8.0;
    return options;
}

Field<Rgb8> point(int x) {
    Field<Rgb8> pixels(160, 160, kWhite);
    pixels(x, 80) = kBlack;
    return pixels;
}

TEST(PassMemory, TheSameAgainSettlesNothing) {
    const Picture stroke(point(80));
    const Options options = with_peak_at(stroke);
    const Made first = made(options, "");
    const Made second = made(options, first.remembered);
    EXPECT_EQ(first.counts.recalled, 0u);
    EXPECT_EQ(second.counts.recalled, second.counts.features);
    EXPECT_EQ(second.heights, first.heights);
    EXPECT_EQ(second.remembered, first.remembered);
}

TEST(PassMemory, AMovedStrokeSettlesLittleAndGivesTheBytesOfAFreshRun) {
    const Picture before(point(80));
    const std::string remembered = made(with_peak_at(before), "").remembered;
    write_png(before.source().path, point(84));
    const Options options = with_peak_at(before);
    const Made again = made(options, remembered);
    const Made fresh = made(options, "");
    EXPECT_EQ(again.heights, fresh.heights);
    EXPECT_GT(again.counts.recalled, 0u);
    EXPECT_LT(again.counts.recalled, again.counts.features);
    EXPECT_EQ(again.counts.features, fresh.counts.features);
}

// A wall that `x` moves, so that passes of others stop elsewhere.
Field<Rgb8> wall(int x) {
    Field<Rgb8> pixels(160, 160, kWhite);
    for (int y = 40; y < 120; ++y) pixels(x, y) = kBlack;
    return pixels;
}

// Step by step, every run with what the one before remembered.
void expect_fresh_bytes(const Picture& stroke, const Options& options) {
    write_png(stroke.source().path, wall(70));
    Options at = options;
    const auto reopen = [&] {
        std::get<Strokes>(at.groups[1].where).image = stroke.source();
    };
    reopen();
    std::string remembered = made(at, "").remembered;
    for (const int x : {72, 77, 69, 90, 70}) {
        write_png(stroke.source().path, wall(x));
        reopen();
        const Made again = made(at, remembered);
        const Made fresh = made(at, "");
        EXPECT_EQ(again.heights, fresh.heights) << x;
        EXPECT_EQ(again.counts.features, fresh.counts.features) << x;
        EXPECT_GT(again.counts.recalled, 0u) << x;
        remembered = again.remembered;
    }
}

TEST(PassMemory, MendsPassesThatStopElsewhere) {
    const Picture stroke(wall(70));
    expect_fresh_bytes(stroke, with_peak_at(stroke));
}

TEST(PassMemory, MendsRawPasses) {
    const Picture stroke(wall(70));
    Options options = with_peak_at(stroke);
    for (Group& group : options.groups) group.profile.clear();
    expect_fresh_bytes(stroke, options);
}

TEST(PassMemory, MendsPassesOverSixteenNeighbours) {
    const Picture stroke(wall(70));
    Options options = with_peak_at(stroke);
    options.neighbours = 16;
    expect_fresh_bytes(stroke, options);
}

TEST(PassMemory, MendsPassesThroughRegionsAndBesideStrokesWithTwoSides) {
    const Picture stroke(wall(70));
    const Picture valley(wall(30));
    Options options = with_peak_at(stroke);
    Profile steep = options.profiles[0];
    steep.name = "steep";
    steep.curve.points = {{0, 1}, {4, 0.3}, {20, 0}};
    options.profiles.push_back(steep);
    options.groups[1].other_side = "steep";
    RegionOptions region;
    region.image = valley.source();
    region.profile = "steep";
    options.regions = {region};
    expect_fresh_bytes(stroke, options);
}

TEST(PassMemory, AFeatureThatStaysIsMendedNotMadeAgain) {
    const Picture stroke(wall(70));
    const Options options = with_peak_at(stroke);
    const std::string remembered = made(options, "").remembered;
    write_png(stroke.source().path, wall(72));
    const Layout layout = layout_of(options, flat(160, 160), 1);
    const Ground ground = layout.ground();
    const auto approximate = approximate_heights(ground, layout.halting);
    const PassMemory memory(ground, layout.halting, remembered);
    LeastCost paths(layout.graph), fresh(layout.graph);
    std::size_t mended = 0, nodes = 0;
    for (int f = 0; f < layout.features.count(); ++f) {
        const auto pass = memory.recalled(f, approximate, paths);
        if (!pass) continue;  // the wall
        pass_of(f, ground, layout.halting, approximate, fresh);
        ASSERT_EQ(pass->nodes.size(), fresh.settled().size());
        for (std::size_t i = 0; i < pass->nodes.size(); ++i) {
            EXPECT_EQ(pass->labels[i].cost, fresh[pass->nodes[i]].cost);
            EXPECT_EQ(pass->labels[i].length, fresh[pass->nodes[i]].length);
            EXPECT_EQ(pass->labels[i].direction, fresh[pass->nodes[i]].direction);
        }
        mended += pass->settled;
        nodes += pass->nodes.size();
    }
    EXPECT_GT(mended, 0u);
    EXPECT_LT(mended, nodes / 10);
}

TEST(PassMemory, ForgetsWhenTheGroundChanges) {
    const Picture stroke(point(80));
    Options options = with_peak_at(stroke);
    const std::string remembered = made(options, "").remembered;
    options.edge_weight_deviation = 1.1;
    EXPECT_EQ(made(options, remembered).counts.recalled, 0u);
    options = with_peak_at(stroke);
    options.sea_level_scale = 7.5;
    EXPECT_EQ(made(options, remembered).counts.recalled, 0u);
    options = with_peak_at(stroke);
    options.profiles[0].curve.points[1][1] = 0.5;
    EXPECT_EQ(made(options, remembered).counts.recalled, 0u);
}

TEST(PassMemory, DamagedBytesCountAsNone) {
    const Picture stroke(point(80));
    const Options options = with_peak_at(stroke);
    const Made first = made(options, "");
    const std::string& good = first.remembered;
    for (std::size_t at : {std::size_t{3}, std::size_t{20}, std::size_t{40},
                           good.size() / 2, good.size() - 1}) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x55);
        const Made again = made(options, bad);
        EXPECT_EQ(again.counts.recalled, 0u) << at;
        EXPECT_EQ(again.heights, first.heights) << at;
    }
    for (std::size_t size : {std::size_t{0}, std::size_t{10}, good.size() - 5}) {
        EXPECT_EQ(made(options, good.substr(0, size)).counts.recalled, 0u) << size;
    }
}

}  // namespace
}  // namespace cydonia::distance
