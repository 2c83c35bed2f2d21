#include "synth/distance/distance.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "field/error.h"
#include "field/image.h"
#include "synth/distance/blend.h"
#include "synth/distance/regions.h"
#include "tests/synth/distance_land.h"

namespace cydonia::distance {
namespace {

struct Cell {
    int x, y;
};
Cell highest_cell(const Field<float>& heights) {
    const auto i = static_cast<int>(std::max_element(heights.begin(), heights.end()) -
                                    heights.begin());
    return {i % heights.width(), i / heights.width()};
}

std::string message_of(const Options& options) {
    try {
        land(options, flat(32, 32));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadRequest);
        return error.what();
    }
    return "";
}

TEST(Distance, OnePeakIsAPolygonalCone) {
    for (const auto metric : {Options::Metric::kEuclidean, Options::Metric::kThesis}) {
        Options options = one_peak();
        options.metric = metric;
        const Terrain terrain = land(options, flat(256, 256));
        const Cell top = highest_cell(terrain.heights);
        for (int y = 0; y < 256; ++y) {
            for (int x = 0; x < 256; ++x) {
                const double a = std::max(std::abs(x - top.x), std::abs(y - top.y));
                const double b = std::min(std::abs(x - top.x), std::abs(y - top.y));
                const double cells =
                    metric == Options::Metric::kThesis ? a : a - b + std::sqrt(2.0) * b;
                const double height = 200.0 - 2.0 * terrain.spacing * cells;
                if (height > 0.5) {
                    ASSERT_NEAR(terrain.heights(x, y), height, 1e-3) << x << ", " << y;
                } else {
                    ASSERT_LE(terrain.heights(x, y), 0.5f);
                }
            }
        }
    }
}

TEST(Distance, OnePeakShowsItsProfile) {
    const Options options =
        shaped(one_peak(), {{0, 10}, {1, 6}, {3, 2}, {8, 0}}, metres(1600.0));
    const Terrain terrain = land(options, flat(1024, 1024));
    const Cell top = highest_cell(terrain.heights);
    // Eq. 3.6: the whole profile in two thirds of sea level's height and reach.
    const auto drawn = [](double metres_out) {
        const double x = metres_out / (1600.0 * 200.0 / 300.0) * 8.0;
        const double f = x < 1   ? 10 - 4 * x
                         : x < 3 ? 6 - 2 * (x - 1)
                                 : std::max(0.0, 2 - 0.4 * (x - 3));
        return 200.0 * f / 10.0;
    };
    const int direction = top.x < 512 ? 1 : -1;
    for (int i = 0; i < 200; ++i) {
        EXPECT_NEAR(terrain.heights(top.x + direction * i, top.y), drawn(5.0 * i), 0.5)
            << 5.0 * i << " m";
    }
}

TEST(Distance, ProfileDrawnAsAPicture) {
    Field<Rgb8> pixels(101, 101, kWhite);
    for (int x = 0; x <= 100; ++x) {
        pixels(x, x) = kBlack;
        pixels(x, std::max(0, x - 1)) = kBlack;
    }
    const Picture picture(pixels);
    Options options = shaped(one_peak(), {{0, 1}, {100, 0}});
    const Terrain listed = land(options, flat(128, 128));
    options.profiles[0].curve.points.clear();
    options.profiles[0].curve.image = picture.source();
    const Terrain drawn = land(options, flat(128, 128));
    for (std::size_t i = 0; i < drawn.heights.size(); ++i) {
        ASSERT_NEAR(drawn.heights[i], listed.heights[i], 2.0);
    }
}

// Two features on one graph, and the heights of each alone.
struct Pair {
    Graph graph =
        graph_of(80, 60, 10.0, {.mean = 1.0, .deviation = 0.6, .grain = 60.0}, 4);
    Features both;
    std::vector<Field<float>> alone;
    BlendOptions options{.bias = 0.0, .bias_map = {}};

    Pair() {
        for (const Start start :
             {Start{graph.node(25, 30), 0.0f}, Start{graph.node(50, 28), 120.0f}}) {
            Features one;
            one.starts = {start};
            one.first = {0, 1};
            one.features.resize(1);
            alone.push_back(heights(one));
            both.starts.push_back(start);
            both.first.push_back(static_cast<int>(both.starts.size()));
            both.features.emplace_back();
        }
    }
    Field<float> heights(const Features& features) const {
        Shapes shapes;
        shapes.sea_level = 400.0;
        const Regions regions;
        const Ground ground{graph, features, shapes, regions};
        const Halting never{0.0f, 0.0f};
        SilentProgress silent;
        return blended_heights(ground, never, options, approximate_heights(ground, never),
                               silent);
    }
};

TEST(Blend, NoBiasIsTheAverage) {
    Pair pair;
    const Field<float> blended = pair.heights(pair.both);
    for (std::size_t i = 0; i < blended.size(); ++i) {
        const float a = pair.alone[0][i], b = pair.alone[1][i];
        const float mean = a > 0 && b > 0 ? 0.5f * (a + b) : a + b;
        ASSERT_NEAR(blended[i], mean, 1e-2);
    }
}

TEST(Blend, StrongBiasIsTheHighest) {
    Pair pair;
    pair.options.bias = 4000.0;
    const Field<float> blended = pair.heights(pair.both);
    for (std::size_t i = 0; i < blended.size(); ++i) {
        ASSERT_NEAR(blended[i], std::max(pair.alone[0][i], pair.alone[1][i]), 0.1);
    }
}

TEST(Blend, BiasBetweenIsEquation37) {
    Pair pair;
    pair.options.bias = 2.5;
    const Field<float> blended = pair.heights(pair.both);
    for (std::size_t i = 0; i < blended.size(); ++i) {
        const double a = pair.alone[0][i], b = pair.alone[1][i];
        if (a <= 0.0 && b <= 0.0) continue;
        const double expected =
            (std::pow(a, 3.5) + std::pow(b, 3.5)) / (std::pow(a, 2.5) + std::pow(b, 2.5));
        ASSERT_NEAR(blended[i], expected, 0.05);
    }
}

// The steepest slope, in metres a metre.
double steepest(const Terrain& terrain) {
    double slope = 0.0;
    for (int y = 0; y < terrain.heights.height(); ++y) {
        for (int x = 1; x < terrain.heights.width(); ++x) {
            const double step = terrain.heights(x, y) - terrain.heights(x - 1, y);
            slope = std::max(slope, std::abs(step) / terrain.spacing);
        }
    }
    return slope;
}

TEST(Blend, NoSeamWhereAFeatureStops) {
    // On weights without chance the land has slopes, whatever the resolution; a seam
    // (figure 3.12a) is a step, twice as steep on a grid twice as fine.
    Options options = running_example();
    options.edge_weight_deviation = 0.0;
    for (const double bias : {0.0, 1.0, 2.0}) {
        options.blending_bias = bias;
        const double coarse = steepest(land(options, flat(128, 128)));
        const double fine = steepest(land(options, flat(384, 384)));
        EXPECT_LT(fine, 1.3 * coarse) << "b = " << bias;
    }
}

TEST(Distance, SameBytesForAnyNumberOfThreads) {
    const Options options = running_example();
    Field<float> heights[2];
    for (int i : {0, 1}) {
        const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                          i == 0 ? 1 : 4);
        heights[i] = land(options, flat(200, 160)).heights;
    }
    EXPECT_EQ(heights[0], heights[1]);
    EXPECT_NE(heights[0], land(options, flat(200, 160), 2).heights);
}

TEST(Distance, SameLandAtEveryResolution) {
    // Blocks of 80 m: the low-pass.
    const auto blocks = [](const Field<float>& heights) {
        const int n = heights.width() / 64;
        Field<float> means(64, 64);
        for (int y = 0; y < heights.height(); ++y) {
            for (int x = 0; x < heights.width(); ++x) {
                means(x / n, y / n) += heights(x, y) / static_cast<float>(n * n);
            }
        }
        return means;
    };
    for (bool drawn : {true, false}) {
        Options options = running_example();
        if (!drawn) options.groups[0].profile.clear();
        const Field<float> coarse = blocks(land(options, flat(256, 256)).heights);
        const Field<float> fine = blocks(land(options, flat(512, 512)).heights);
        double squares = 0.0;
        for (std::size_t i = 0; i < fine.size(); ++i) {
            squares += std::pow(coarse[i] - fine[i], 2.0);
        }
        const double rms = std::sqrt(squares / static_cast<double>(fine.size()));
        const float relief = *std::max_element(fine.begin(), fine.end());
        EXPECT_LT(rms, 0.02 * relief);
        RecordProperty(drawn ? "rms_with_profile" : "rms_without", std::to_string(rms));
    }
}

TEST(Distance, AddedToTheLandSoFar) {
    const Options options = running_example();
    Terrain ground = flat(64, 64);
    const Terrain alone = land(options, ground);
    for (float& height : ground.heights) height = 1000.0f;
    ground.masks["shore"] = Field<float>(64, 64, 0.5f);
    const Terrain both = land(options, ground);
    for (std::size_t i = 0; i < alone.heights.size(); ++i) {
        ASSERT_FLOAT_EQ(both.heights[i], 1000.0f + alone.heights[i]);
    }
    EXPECT_EQ(both.masks.count("shore"), 1u);
}

TEST(SeaLevel, HalfClipsTheLowFeatures) {
    Options options = running_example();
    const Terrain all = land(options, flat(128, 128));
    options.sea_level_scale = 0.5;
    const Terrain half = land(options, flat(128, 128));
    const auto above = [](const Terrain& terrain) {
        return std::count_if(terrain.heights.begin(), terrain.heights.end(),
                             [](float h) { return h > 0.0f; });
    };
    EXPECT_GT(above(half), 0);
    EXPECT_LT(above(half), above(all));
    for (float height : half.heights) ASSERT_TRUE(height >= 0.0f && height < 1000.0f);
}

TEST(SeaLevel, AtTheHighestCost) {
    Options options = one_peak();
    options.sea_level_scale = 1.0;
    options = shaped(options, {{0, 1}, {100, 0}});
    // The only peak lies at sea level: eq. 3.6 would divide by zero.
    EXPECT_EQ(land(options, flat(32, 32)).heights, Field<float>(32, 32));
    count_of(options) = 5;
    set_range(options, 10.0, 300.0);
    const Terrain terrain = land(options, flat(64, 64));
    for (float height : terrain.heights) ASSERT_TRUE(std::isfinite(height));
    EXPECT_GT(*std::max_element(terrain.heights.begin(), terrain.heights.end()), 10.0f);
}

TEST(SeaLevel, AllCostsZero) {
    Options options = one_peak();
    set_range(options, 0.0, 0.0);
    EXPECT_EQ(land(options, flat(32, 32)).heights, Field<float>(32, 32));
}

TEST(DistanceRefuses, OptionsOutOfRange) {
    const auto refused = [](auto change) {
        Options options = running_example();
        change(options);
        return message_of(options);
    };
    EXPECT_NE(refused([](Options& o) {
                  o.edge_weight_deviation = 2.0;
              }).find("edge_weight_deviation"),
              std::string::npos);
    EXPECT_NE(
        refused([](Options& o) { o.mean_edge_weight = 0.0; }).find("mean_edge_weight"),
        std::string::npos);
    EXPECT_NE(refused([](Options& o) { o.blending_bias = -1.0; }).find("blending_bias"),
              std::string::npos);
    EXPECT_NE(
        refused([](Options& o) { o.sea_level_scale = 0.0; }).find("sea_level_scale"),
        std::string::npos);
    EXPECT_NE(refused([](Options& o) { o.grain = metres(0.0); }).find("grain"),
              std::string::npos);
}

}  // namespace
}  // namespace cydonia::distance
