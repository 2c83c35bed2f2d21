#include "synth/distance/distance.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "field/error.h"
#include "field/image.h"
#include "synth/distance/blend.h"
#include "synth/distance/features.h"

namespace cydonia::distance {
namespace {

Terrain flat(int width, int height, double extent = 5120.0) {
    Terrain terrain;
    terrain.heights = Field<float>(width, height);
    terrain.spacing = extent / width;
    return terrain;
}

Terrain land(const Options& options, const Terrain& ground, std::uint64_t seed = 1) {
    SilentProgress silent;
    Context context;
    context.seed = seed;
    context.progress = &silent;
    return run(options, ground, context);
}

// Rusnell 2009, chapter 3's example.
Options running_example() {
    Options options;
    options.peaks.count = 25;
    options.ridges.count = 38;
    for (int i = 0; i <= 20; ++i) {
        const double x = i / 20.0;
        options.profile.points.push_back({130.0 * x, (1.0 - x) * (1.0 - x)});
    }
    return options;
}

// One peak, 200 m above a sea level cost of 300 m, on weights without chance.
Options one_peak() {
    Options options;
    options.peaks.count = 1;
    options.peaks.cost = {.kind = CostRule::Kind::kRandom,
                          .noise = {},
                          .range = {metres(100.0), metres(100.0)}};
    options.sea_level_scale = 3.0;
    options.edge_weight_deviation = 0.0;
    options.sea_level_threshold = metres(0.1);
    return options;
}

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

class Picture {
  public:
    explicit Picture(const Field<Rgb8>& pixels)
        : path_(std::filesystem::temp_directory_path() /
                ("cydonia-distance-" +
                 std::string(
                     testing::UnitTest::GetInstance()->current_test_info()->name()) +
                 ".png")) {
        write_png(path_, pixels);
    }
    ~Picture() { std::filesystem::remove(path_); }
    Source source() const { return open_source(path_); }

  private:
    std::filesystem::path path_;
};

constexpr Rgb8 kWhite{255, 255, 255}, kBlack{0, 0, 0}, kRed{255, 0, 0};

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
    Options options = one_peak();
    options.profile.points = {{0, 10}, {1, 6}, {3, 2}, {8, 0}};
    options.profile.reach = metres(1600.0);
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
    Options options = one_peak();
    options.profile.image = picture.source();
    const Terrain drawn = land(options, flat(128, 128));
    options.profile = {.image = {}, .points = {{0, 1}, {100, 0}}, .reach = {}};
    const Terrain listed = land(options, flat(128, 128));
    for (std::size_t i = 0; i < drawn.heights.size(); ++i) {
        ASSERT_NEAR(drawn.heights[i], listed.heights[i], 2.0);
    }
}

// Two features on one graph, and what each gives alone.
struct Pair {
    Graph graph =
        graph_of(80, 60, 10.0, {.mean = 1.0, .deviation = 0.6, .grain = 60.0}, 4);
    Features both;
    std::vector<Field<float>> alone;
    BlendOptions options{.sea_level = 400.0,
                         .bias = 0.0,
                         .sea_level_threshold = 0.0,
                         .approximate_threshold = 0.0,
                         .mean_edge_weight = 1.0};

    Pair() {
        for (const Start start :
             {Start{graph.node(25, 30), 0.0f}, Start{graph.node(50, 28), 120.0f}}) {
            Features one;
            one.starts = {start};
            one.first = {0, 1};
            alone.push_back(heights(one));
            both.starts.push_back(start);
            both.first.push_back(static_cast<int>(both.starts.size()));
        }
    }
    Field<float> heights(const Features& features) const {
        SilentProgress silent;
        return blended_heights(graph, features, nullptr, options, silent);
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

// Metres up a metre along, at its worst.
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
        if (!drawn) options.profile = {};
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
    options.profile.points = {{0, 1}, {100, 0}};
    // The only peak lies at sea level: eq. 3.6 would divide by zero.
    EXPECT_EQ(land(options, flat(32, 32)).heights, Field<float>(32, 32));
    options.peaks.count = 5;
    options.peaks.cost.range = {metres(10.0), metres(300.0)};
    const Terrain terrain = land(options, flat(64, 64));
    for (float height : terrain.heights) ASSERT_TRUE(std::isfinite(height));
    EXPECT_GT(*std::max_element(terrain.heights.begin(), terrain.heights.end()), 10.0f);
}

TEST(SeaLevel, AllCostsZero) {
    Options options = one_peak();
    options.peaks.cost.range = {metres(0.0), metres(0.0)};
    EXPECT_EQ(land(options, flat(32, 32)).heights, Field<float>(32, 32));
}

Graph grid(int width, int height) {
    return graph_of(width, height, 10.0, {.mean = 2.0, .deviation = 1.0}, 1);
}

TEST(Features, AConnectedPieceOfOneColour) {
    Field<Rgb8> pixels(12, 8, kWhite);
    pixels(1, 1) = pixels(2, 2) = pixels(3, 2) = kBlack;  // touching by a corner: one
    pixels(4, 2) = kRed;                                  // another colour: another
    pixels(9, 6) = kBlack;                                // apart: another
    const Picture picture(pixels);
    Options options;
    options.strokes = picture.source();
    const Features features = features_of(options, grid(12, 8), 1);
    ASSERT_EQ(features.count(), 3);
    std::vector<std::size_t> sizes;
    for (int f = 0; f < 3; ++f) sizes.push_back(features.of(f).size());
    std::sort(sizes.begin(), sizes.end());
    EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 3}));
}

TEST(Features, LeastNoiseCostIsZero) {
    Options options;
    options.peaks.count = 40;
    const Features features = features_of(options, grid(64, 64), 3);
    float least = kUnreached, most = 0.0f;
    for (const Start& start : features.starts) {
        least = std::min(least, start.cost);
        most = std::max(most, start.cost);
    }
    EXPECT_EQ(least, 0.0f);
    EXPECT_GT(most, 5.0f);
}

TEST(Features, RandomCostsLieInTheirRange) {
    Options options;
    options.peaks = {.count = 200,
                     .cost = {.kind = CostRule::Kind::kRandom,
                              .noise = {},
                              .range = {metres(20.0), metres(30.0)}}};
    float least = kUnreached, most = 0.0f;
    for (const Start& start : features_of(options, grid(64, 64), 3).starts) {
        least = std::min(least, start.cost);
        most = std::max(most, start.cost);
    }
    EXPECT_TRUE(least >= 20.0f && least < 21.0f && most > 29.0f && most <= 30.0f);
}

TEST(Features, RidgesExtendTheirPeak) {
    Options options;
    options.peaks.count = 4;
    options.grain = metres(40.0);  // ridges grow on a grid of 10 m, this one
    const Graph graph = grid(96, 96);
    const Features peaks = features_of(options, graph, 3);
    options.ridges = {.count = 12, .cost_factor = 0.25};
    const Features ridges = features_of(options, graph, 3);
    ASSERT_EQ(ridges.count(), 4);
    LeastCost paths(graph);
    paths.spread(peaks.starts, RawGrowth{peaks.starts});
    std::size_t nodes = 0;
    for (int f = 0; f < 4; ++f) {
        for (const Start& start : ridges.of(f).subspan(1)) {
            EXPECT_EQ(paths[start.node].origin, f);
            EXPECT_EQ(start.cost, 0.25f * paths[start.node].cost);
            ++nodes;
        }
    }
    EXPECT_GT(nodes, 100u);
}

TEST(Features, RidgesAreWholeOnAFinerGrid) {
    Options options;
    options.peaks.count = 1;
    options.ridges.count = 1;
    options.grain = metres(40.0);
    const Graph graph = graph_of(384, 384, 2.5, {}, 1);
    const Features features = features_of(options, graph, 3);
    const auto ridge = features.of(0).subspan(1);
    ASSERT_GT(ridge.size(), 40u);
    for (std::size_t i = 1; i < ridge.size(); ++i) {
        const int x = graph.x_of(ridge[i].node) - graph.x_of(ridge[i - 1].node);
        const int y = graph.y_of(ridge[i].node) - graph.y_of(ridge[i - 1].node);
        ASSERT_LE(std::max(std::abs(x), std::abs(y)), 1);
    }
}

TEST(Features, SamePlacesAtEveryResolution) {
    Options options;
    options.peaks.count = 10;
    const Graph coarse = grid(50, 40), fine = grid(500, 400);
    const Features a = features_of(options, coarse, 3), b = features_of(options, fine, 3);
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(coarse.x_of(a.starts[i].node), fine.x_of(b.starts[i].node) / 10);
        EXPECT_EQ(coarse.y_of(a.starts[i].node), fine.y_of(b.starts[i].node) / 10);
    }
}

TEST(DistanceRefuses, NoFeature) {
    EXPECT_NE(message_of({}).find("no features"), std::string::npos);
    Options options;
    options.ridges.count = 5;
    EXPECT_NE(message_of(options).find("no features"), std::string::npos);
}

TEST(DistanceRefuses, StrokesWithoutAPixel) {
    const Picture picture(Field<Rgb8>(8, 8, kWhite));
    Options options;
    options.strokes = picture.source();
    EXPECT_NE(message_of(options), "");
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
    EXPECT_NE(refused([](Options& o) { o.peaks.count = 2000; }).find("peaks count"),
              std::string::npos);
}

}  // namespace
}  // namespace cydonia::distance
