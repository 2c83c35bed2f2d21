// Numbers that vary over the land: mu_w, r, b, and whole weights from a picture.

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "synth/distance/graph.h"
#include "synth/distance/layout.h"
#include "tests/synth/distance_land.h"

namespace cydonia::distance {
namespace {

// Black in the west, white in the east.
Field<Rgb8> halves(int side) {
    Field<Rgb8> pixels(side, side, kWhite);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side / 2; ++x) pixels(x, y) = kBlack;
    return pixels;
}

TEST(Map, MeanEdgeWeight) {
    const Picture picture(halves(64));
    EdgeOptions edges{.mean = 2.0, .deviation = 0.0};
    edges.mean_map = Map{picture.source(), {0.5, 3.0}};
    const Graph graph = graph_of(64, 64, 10.0, edges, 1);
    EXPECT_NEAR(graph.edge(graph.node(10, 10), 0), 5.0f, 1e-3f);
    EXPECT_NEAR(graph.edge(graph.node(50, 10), 0), 30.0f, 1e-3f);
    EXPECT_NEAR(graph.edge(graph.node(31, 10), 0), 17.5f, 1e-3f);  // across
}

TEST(Map, EdgeWeightDeviation) {
    const Picture picture(halves(64));
    EdgeOptions edges{.mean = 2.0, .deviation = 1.0, .grain = 40.0};
    edges.deviation_map = Map{picture.source(), {0.0, 1.5}};
    const Graph graph = graph_of(64, 64, 10.0, edges, 1);
    float spread = 0.0f;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 30; ++x)
            EXPECT_NEAR(graph.edge(graph.node(x, y), 0), 20.0f, 1e-3f);
        for (int x = 33; x < 62; ++x)
            spread = std::max(spread, std::abs(graph.edge(graph.node(x, y), 0) - 20.0f));
    }
    EXPECT_GT(spread, 5.0f);
    EXPECT_LE(spread, 15.0f);
}

TEST(Map, WholeWeightsAreTheMeanOfTheEnds) {
    const Picture picture(halves(64));
    EdgeOptions edges;
    edges.weights = Map{picture.source(), {0.25, 2.5}};
    const Graph graph = graph_of(64, 64, 10.0, edges, 1);
    EXPECT_NEAR(graph.edge(graph.node(10, 10), 0), 2.5f, 1e-3f);
    EXPECT_NEAR(graph.edge(graph.node(31, 10), 0), 13.75f, 1e-3f);
    EXPECT_NEAR(graph.edge(graph.node(50, 10), 1), 25.0f * std::sqrt(2.0f), 1e-3f);
}

TEST(Map, WeightsOfNothingAreRefused) {
    const Picture picture(halves(64));
    EdgeOptions edges;
    edges.weights = Map{picture.source(), {0.0, 2.5}};
    EXPECT_THROW(graph_of(64, 64, 10.0, edges, 1), Error);
}

TEST(Map, BlendingBias) {
    // Two peaks as high as each other: averaged in the west, the highest in the east.
    Options options = one_peak();
    count_of(options) = 12;
    set_range(options, 60.0, 100.0);
    options.sea_level_scale = 12.0;
    const auto with_bias = [&](double bias) {
        Options same = options;
        same.blending_bias = bias;
        return land(same, flat(128, 128)).heights;
    };
    const Field<float> low = with_bias(0.0), high = with_bias(8.0);
    const Picture picture(halves(128));
    options.blending_bias_map = Map{picture.source(), {0.0, 8.0}};
    const Field<float> both = land(options, flat(128, 128)).heights;
    double difference = 0.0;
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 62; ++x) {
            ASSERT_NEAR(both(x, y), low(x, y), 1e-2f);
            difference = std::max(difference, 1.0 * std::abs(low(x, y) - high(x, y)));
        }
        for (int x = 66; x < 128; ++x) ASSERT_NEAR(both(x, y), high(x, y), 1e-2f);
    }
    EXPECT_GT(difference, 5.0);
}

TEST(Options, VerticalScale) {
    Options options = one_peak();
    const Field<float> whole = land(options, flat(64, 64)).heights;
    options.vertical_scale = 0.45;
    const Field<float> scaled = land(options, flat(64, 64)).heights;
    for (std::size_t i = 0; i < whole.size(); ++i)
        ASSERT_FLOAT_EQ(scaled[i], 0.45f * whole[i]);
}

TEST(Options, CombineReplaces) {
    Options options = one_peak();
    const Field<float> alone = land(options, flat(64, 64)).heights;
    Terrain ground = flat(64, 64);
    for (float& height : ground.heights) height = 1000.0f;
    options.combine = Options::Combine::kReplace;
    EXPECT_EQ(land(options, ground).heights, alone);
}

TEST(Options, CombineReplacesByFlatLandWhereNoneRises) {
    Options options = one_peak();
    set_range(options, 0.0, 0.0);
    Terrain ground = flat(32, 32);
    for (float& height : ground.heights) height = 1000.0f;
    EXPECT_EQ(land(options, ground).heights, ground.heights);
    options.combine = Options::Combine::kReplace;
    EXPECT_EQ(land(options, ground).heights, Field<float>(32, 32));
}

TEST(Options, PreviewIsTheHighestFeature) {
    // With each peak alone on the land, the highest of them everywhere.
    Options options = one_peak();
    count_of(options) = 3;
    options.preview = true;
    const Terrain ground = flat(96, 96);
    const Layout layout = layout_of(options, ground, 1);
    const Field<float> preview = land(options, ground).heights;
    Field<float> highest(96, 96);
    LeastCost paths(layout.graph);
    const std::vector<float> nothing(static_cast<std::size_t>(layout.graph.nodes()));
    for (int f = 0; f < 3; ++f) {
        const Pass pass = pass_of(f, layout.ground(), layout.halting, nothing, paths);
        for (std::size_t i = 0; i < pass.nodes.size(); ++i) {
            float& cell = highest(layout.graph.x_of(pass.nodes[i]),
                                  layout.graph.y_of(pass.nodes[i]));
            cell = std::max(cell, pass.heights[i]);
        }
    }
    EXPECT_EQ(preview, highest);
}

}  // namespace
}  // namespace cydonia::distance
