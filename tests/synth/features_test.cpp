#include "synth/distance/features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "field/image.h"
#include "field/random.h"
#include "synth/distance/cost_model.h"
#include "synth/distance/sources.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::distance {
namespace {

constexpr double kWidth = 5120.0;  // metres; a thesis unit is 10
constexpr Rgb8 kWhite{255, 255, 255}, kBlack{0, 0, 0}, kRed{255, 0, 0};
using Kind = CostRule::Kind;

Terrain flat(int width, int height) {
    Terrain terrain;
    terrain.heights = Field<float>(width, height);
    terrain.spacing = kWidth / width;
    return terrain;
}

struct Land {
    Graph graph;
    Features features;

    Land(const Options& options, const Terrain& terrain, std::uint64_t seed = 1)
        : graph(graph_of(terrain.heights.width(), terrain.heights.height(),
                         terrain.spacing, edges_of(options, terrain.width()), seed)),
          features(features_of(options, graph, terrain, seed)) {}
    Land(const Options& options, int samples, std::uint64_t seed = 1)
        : Land(options, flat(samples, samples), seed) {}

    // Metres from the west and north edges.
    double x(const Start& start) const {
        return (graph.x_of(start.node) + 0.5) * graph.spacing;
    }
    double y(const Start& start) const {
        return (graph.y_of(start.node) + 0.5) * graph.spacing;
    }
    double distance(const Start& a, const Start& b) const {
        return std::hypot(x(a) - x(b), y(a) - y(b));
    }
    std::vector<Start> of_group(int group) const {
        std::vector<Start> starts;
        for (int f = 0; f < features.count(); ++f) {
            if (features.features[f].group != group) continue;
            const auto some = features.of(f);
            starts.insert(starts.end(), some.begin(), some.end());
        }
        return starts;
    }
    double distance_to(const std::vector<Start>& starts, const Start& from) const {
        double least = 1e300;
        for (const Start& s : starts) least = std::min(least, distance(s, from));
        return least;
    }
};

// A drawing of a test, which is removed with this object.
class Pictures {
  public:
    Source svg(const std::string& body) {
        return open_source(folder_.with(
            name() + ".svg",
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 512 512'>" + body +
                "</svg>"));
    }
    Source png(const Field<Rgb8>& pixels) {
        const auto path = folder_ / (name() + ".png");
        write_png(path, pixels);
        return open_source(path);
    }

  private:
    std::string name() { return "picture" + std::to_string(count_++); }
    TemporaryFolder folder_;
    int count_ = 0;
};

// A line in thesis units.
std::string line(double x0, double y0, double x1, double y1,
                 const std::string& colour = "#000") {
    return "<line x1='" + std::to_string(x0) + "' y1='" + std::to_string(y0) + "' x2='" +
           std::to_string(x1) + "' y2='" + std::to_string(y1) + "' stroke='" + colour +
           "' stroke-width='1'/>";
}

Options with(std::vector<Group> groups) {
    Options options;
    options.groups = std::move(groups);
    return options;
}

Group group_of(const std::string& name, decltype(Group::where) where) {
    Group group;
    group.name = name;
    group.where = std::move(where);
    return group;
}

Group peaks(int count, const std::string& name = "peaks") {
    Peaks where;
    where.placement.count = count;
    return group_of(name, where);
}

CostRule constant(double metres_of_cost) {
    CostRule rule;
    rule.kind = Kind::kRandom;
    rule.range = {{metres(metres_of_cost), metres(metres_of_cost)}};
    return rule;
}

std::string message_of(const Options& options) {
    try {
        Land(options, 32);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadRequest) << error.what();
        return error.what();
    }
    return "no error";
}

void expect_refused(const Options& options, const std::string& words) {
    const std::string message = message_of(options);
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

// Whether a node is connected with the land's edge across the sides of cells.
bool leads_out(const Land& land, int feature, int node) {
    Field<char> seen(land.graph.width, land.graph.height);
    for (const Start& start : land.features.of(feature)) {
        seen(land.graph.x_of(start.node), land.graph.y_of(start.node)) = 1;
    }
    std::vector<std::array<int, 2>> front{{land.graph.x_of(node), land.graph.y_of(node)}};
    while (!front.empty()) {
        const auto [x, y] = front.back();
        front.pop_back();
        if (!seen.contains(x, y)) return true;
        if (std::exchange(seen(x, y), 1)) continue;
        front.insert(front.end(), {{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}});
    }
    return false;
}

// ---- Strokes

TEST(Strokes, AConnectedPieceOfOneColour) {
    Field<Rgb8> pixels(12, 8, kWhite);
    pixels(1, 1) = pixels(2, 2) = pixels(3, 2) = kBlack;  // touching by a corner: one
    pixels(4, 2) = kRed;                                  // another colour: another
    pixels(9, 6) = kBlack;                                // apart: another
    Pictures pictures;
    const Land land(with({group_of("all", Strokes{pictures.png(pixels), {}})}),
                    flat(12, 8));
    ASSERT_EQ(land.features.count(), 3);
    std::vector<std::size_t> sizes;
    for (int f = 0; f < 3; ++f) sizes.push_back(land.features.of(f).size());
    std::sort(sizes.begin(), sizes.end());
    EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 3}));
}

TEST(Strokes, OfAColour) {
    Pictures pictures;
    const Source both =
        pictures.svg(line(50, 100, 400, 100, "#f00") + line(50, 300, 400, 300, "#00f") +
                     line(50, 400, 400, 400, "#f00"));
    const Land land(with({group_of("blue", Strokes{both, {{0, 0, 255}}}),
                          group_of("red", Strokes{both, {{255, 0, 0}}})}),
                    256);
    ASSERT_EQ(land.features.count(), 3);
    EXPECT_EQ(land.features.features[0].group, 0);
    EXPECT_EQ(land.features.features[1].group, 1);
    EXPECT_EQ(land.features.features[2].group, 1);
    for (const Start& start : land.of_group(0)) {
        EXPECT_NEAR(land.y(start), 3000.0, 20.0);
    }
}

TEST(Strokes, FringesOfAnAntialiasedPictureAreNothing) {
    Field<Rgb8> pixels(64, 64, kWhite);
    for (int x = 10; x < 50; ++x) {
        pixels(x, 30) = {250, 6, 4};  // nearly the named colour
        pixels(x, 29) = pixels(x, 31) = {255, 120, 120};
        pixels(x, 50) = {20, 20, 235};
    }
    Pictures pictures;
    const Source source = pictures.png(pixels);
    const Land land(with({group_of("red", Strokes{source, {{255, 0, 0}}}),
                          group_of("blue", Strokes{source, {{0, 0, 255}}})}),
                    flat(64, 64));
    ASSERT_EQ(land.features.count(), 2);
    EXPECT_EQ(land.features.of(0).size(), 40u);
    EXPECT_EQ(land.features.of(1).size(), 40u);
}

TEST(Strokes, APictureOfManyColoursIsOneDrawing) {
    Field<Rgb8> pixels(64, 64, kWhite);
    for (int x = 10; x < 50; ++x) {
        const auto grey = static_cast<std::uint8_t>(x);
        pixels(x, 30) = {grey, grey, grey};
        pixels(x, 31) = {200, 200, 200};
    }
    Pictures pictures;
    const Land land(with({group_of("all", Strokes{pictures.png(pixels), {}})}),
                    flat(64, 64));
    ASSERT_EQ(land.features.count(), 1);
    EXPECT_EQ(land.features.of(0).size(), 40u);
}

TEST(Strokes, TheSamePiecesAtEveryResolution) {
    Pictures pictures;
    // Two strokes a thesis unit apart: less than a cell of 256 samples.
    Group group = group_of(
        "all",
        Strokes{pictures.svg(line(50, 100, 400, 180) + line(50, 102.5, 400, 182.5)), {}});
    group.cost = constant(0.0);
    group.cost.range = {{metres(0.0), metres(300.0)}};
    const Options options = with({group});
    const Land fine(options, 1024);
    ASSERT_EQ(fine.features.count(), 2);
    for (const int samples : {128, 256, 512}) {
        const Land land(options, samples);
        ASSERT_EQ(land.features.count(), 2) << samples;
        for (int f = 0; f < 2; ++f) {
            EXPECT_EQ(land.features.of(f)[0].cost, fine.features.of(f)[0].cost);
        }
    }
}

TEST(Strokes, AFinerLandHasThemFiner) {
    Pictures pictures;
    const auto ring = [&](const std::string& breadth) {
        return with({group_of(
            "ring", Strokes{pictures.svg("<circle cx='256' cy='256' r='100' fill='none' "
                                         "stroke='#000' stroke-width='" +
                                         breadth + "'/>"),
                            {}})});
    };
    const Land land(ring("2"), 2048);
    for (const Start& start : land.features.starts) {
        const double radius = std::hypot(land.x(start) - 2560.0, land.y(start) - 2560.0);
        ASSERT_NEAR(radius, 1000.0, 10.0 + 2.0);
    }
    // A thin one has no gap at any resolution.
    for (const int samples : {100, 1200, 2100}) {
        const Land thin(ring("0.3"), samples);
        ASSERT_EQ(thin.features.count(), 1);
        EXPECT_FALSE(leads_out(thin, 0, thin.graph.node(samples / 2, samples / 2)));
    }
}

// ---- Places

TEST(Places, TheSameAtEveryResolution) {
    const Options options = with({peaks(60)});
    const Land a(options, 256), b(options, 512), c(options, 1024);
    for (int i = 0; i < 60; ++i) {
        for (const auto& [coarse, fine] : {std::pair{&a, &b}, {&b, &c}}) {
            const Start p = coarse->features.starts[i], q = fine->features.starts[i];
            EXPECT_EQ(coarse->graph.x_of(p.node), fine->graph.x_of(q.node) / 2);
            EXPECT_EQ(coarse->graph.y_of(p.node), fine->graph.y_of(q.node) / 2);
            EXPECT_EQ(p.cost, q.cost);
        }
    }
}

TEST(Places, AnotherGroupOrCountMovesNone) {
    const auto nodes_of_last = [](std::vector<Group> groups) {
        const int last = static_cast<int>(groups.size()) - 1;
        std::vector<int> result;
        for (const Start& start : Land(with(std::move(groups)), 512).of_group(last)) {
            result.push_back(start.node);
        }
        return result;
    };
    const std::vector<int> alone = nodes_of_last({peaks(10, "hills")});
    EXPECT_EQ(alone, nodes_of_last({peaks(3, "before"), peaks(10, "hills")}));
    EXPECT_NE(alone, nodes_of_last({peaks(10, "other")}));
    std::vector<int> more = nodes_of_last({peaks(15, "hills")});
    more.resize(10);
    EXPECT_EQ(alone, more);
}

TEST(Places, ApartAndAway) {
    Group close = peaks(40, "close"), first = peaks(5, "first");
    Placement& placement = std::get<Peaks>(close.where).placement;
    placement.apart = metres(300.0);
    placement.away = {{"first", metres(700.0)}};
    const Land land(with({first, close}), 512);
    const std::vector<Start> mountains = land.of_group(0), hills = land.of_group(1);
    ASSERT_EQ(hills.size(), 40u);
    for (std::size_t i = 0; i < hills.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(land.distance(hills[i], hills[j]), 300.0 - 15.0);
        }
        EXPECT_GT(land.distance_to(mountains, hills[i]), 700.0 - 15.0);
    }
}

TEST(Places, KeepOutOfWhatIsDrawn) {
    Group group = peaks(300);
    Pictures pictures;
    // The west black, the middle half grey.
    std::get<Peaks>(group.where).placement.keep_out = pictures.svg(
        "<rect width='170.67' height='512' fill='#000'/>"
        "<rect x='170.67' width='170.67' height='512' fill='#808080'/>");
    const Land land(with({group}), 512);
    std::array<int, 3> thirds{};
    for (const Start& start : land.features.starts) {
        ++thirds[static_cast<int>(land.x(start) / kWidth * 3.0)];
    }
    EXPECT_EQ(thirds[0], 0);
    EXPECT_NEAR(thirds[1], 100, 25);
    EXPECT_NEAR(thirds[2], 200, 25);
}

TEST(Places, DensityIsASquareKilometre) {
    Group group = peaks(0);
    std::get<Peaks>(group.where).placement.density = 2.0;
    EXPECT_EQ(Land(with({group}), 64).features.count(), 52);  // of 26.2 km2
}

// ---- Circles

Group circles(int count, double low, double high, double roughness) {
    Circles where;
    where.placement.count = count;
    where.radius = {metres(low), metres(high)};
    where.roughness = roughness;
    return group_of("circles", where);
}

// Centres are the places that peaks of the same name would have.
std::vector<Start> centres(int count, const Land& land) {
    return Land(with({peaks(count, "circles")}), land.graph.width).features.starts;
}

TEST(CircleShapes, WithoutRoughnessHaveTheirRadius) {
    for (const int samples : {256, 512, 1024}) {
        const Land land(with({circles(12, 400.0, 400.0, 0.0)}), samples);
        const std::vector<Start> middles = centres(12, land);
        for (int f = 0; f < 12; ++f) {
            for (const Start& start : land.features.of(f)) {
                ASSERT_NEAR(land.distance(start, middles[f]), 400.0,
                            1.5 * land.graph.spacing);
            }
        }
    }
}

TEST(CircleShapes, RadiiFillTheirInterval) {
    const Land land(with({circles(60, 100.0, 500.0, 0.0)}), 512);
    const std::vector<Start> middles = centres(60, land);
    double least = 1e9, most = 0.0;
    for (int f = 0; f < 60; ++f) {
        const double radius = land.distance(land.features.of(f)[0], middles[f]);
        least = std::min(least, radius);
        most = std::max(most, radius);
    }
    EXPECT_TRUE(least > 85.0 && least < 140.0) << least;
    EXPECT_TRUE(most > 460.0 && most < 515.0) << most;
}

TEST(CircleShapes, RoughRimsKeepWithinTheirShare) {
    const Land land(with({circles(12, 400.0, 400.0, 0.2)}), 1024);
    const std::vector<Start> middles = centres(12, land);
    double least = 1e9, most = 0.0;
    for (int f = 0; f < 12; ++f) {
        for (const Start& start : land.features.of(f)) {
            const double radius = land.distance(start, middles[f]);
            least = std::min(least, radius);
            most = std::max(most, radius);
        }
    }
    EXPECT_TRUE(least > 312.0 && least < 370.0) << least;
    EXPECT_TRUE(most < 488.0 && most > 430.0) << most;
}

TEST(CircleShapes, RimsHaveNoGapAtAnyResolution) {
    for (const int samples : {128, 512, 2048}) {
        const Land land(with({circles(8, 350.0, 350.0, 0.3)}), samples);
        const std::vector<Start> middles = centres(8, land);
        int whole = 0;
        for (int f = 0; f < 8; ++f) {
            const double x = land.x(middles[f]), y = land.y(middles[f]);
            const double edge = std::min({x, y, kWidth - x, kWidth - y});
            if (edge < 480.0) continue;
            ++whole;
            EXPECT_FALSE(leads_out(land, f, middles[f].node)) << samples << ", " << f;
        }
        EXPECT_GE(whole, 3);
    }
}

TEST(CircleShapes, ASmallerOneErasesTheRimsUnderIt) {
    const Land land(with({circles(30, 200.0, 700.0, 0.0)}), 512);
    const std::vector<Start> middles = centres(30, land);
    std::vector<double> radii;
    for (int f = 0; f < 30; ++f) {
        radii.push_back(land.distance(land.features.of(f)[0], middles[f]));
    }
    int erased = 0;
    for (int f = 0; f < 30; ++f) {
        for (int g = 0; g < 30; ++g) {
            if (radii[g] > radii[f] - 20.0) continue;
            const double apart = land.distance(middles[f], middles[g]);
            if (std::abs(apart - radii[f]) < radii[g]) ++erased;  // it lay on the rim
            for (const Start& start : land.features.of(f)) {
                ASSERT_GT(land.distance(start, middles[g]), radii[g] - 20.0);
            }
        }
    }
    EXPECT_GT(erased, 10);
}

// ---- Edges, terraces, the lip

Field<Rgb8> square(int size, int from, int to) {
    Field<Rgb8> pixels(size, size, kWhite);
    for (int y = from; y < to; ++y) {
        for (int x = from; x < to; ++x) pixels(x, y) = kBlack;
    }
    return pixels;
}

TEST(EdgeShapes, OfASquareAreOneClosedPiece) {
    Pictures pictures;
    Edges edges;
    edges.image = pictures.png(square(128, 40, 80));
    for (const int samples : {64, 128, 500}) {
        const Land land(with({group_of("edges", edges)}), samples);
        ASSERT_EQ(land.features.count(), 1) << samples;
        const int middle = samples * 60 / 128;
        EXPECT_FALSE(leads_out(land, 0, land.graph.node(middle, middle)));
        for (const Start& start : land.features.of(0)) {
            const double x = land.x(start) / 40.0, y = land.y(start) / 40.0;
            const double out = std::max(std::abs(x - 60.0), std::abs(y - 60.0));
            ASSERT_NEAR(out, 20.0, 1.0 + 64.0 / samples);
        }
    }
}

TEST(TerraceShapes, AreTheirSharesOfTheGreatestCost) {
    Pictures pictures;
    Options options;
    options.edge_weight_deviation = 0.0;
    Terraces terraces;
    // Far in the west: the cost grows evenly to the east.
    terraces.image = pictures.svg("<rect width='2' height='512'/>");
    terraces.levels = {{{0.875, 1.0}, metres(0.0)},
                       {{0.5, 0.875}, metres(400.0)},
                       {{0.125, 0.5}, metres(800.0)}};
    options.groups = {group_of("terraces", terraces)};
    for (const int samples : {128, 512, 1024}) {
        const Land land(options, samples);
        ASSERT_EQ(land.features.count(), 3);
        for (int level = 0; level < 3; ++level) {
            const auto [low, high] = terraces.levels[level].range;
            double west = 1e9, east = 0.0;
            for (const Start& start : land.features.of(level)) {
                EXPECT_EQ(start.cost, 400.0f * static_cast<float>(level));
                west = std::min(west, land.x(start));
                east = std::max(east, land.x(start));
            }
            EXPECT_NEAR(west, low * kWidth, 15.0 + land.graph.spacing);
            EXPECT_NEAR(east, high * kWidth, 15.0 + land.graph.spacing);
        }
    }
}

TEST(LipShape, LiesAtItsDistance) {
    Pictures pictures;
    Options options;
    options.mean_edge_weight = 1.5;
    options.edge_weight_deviation = 0.0;
    options.groups = {
        group_of("lip", Lip{pictures.svg(line(100, 256, 400, 256)), metres(200.0)})};
    for (const int samples : {128, 512, 1024}) {
        const Land land(options, samples);
        ASSERT_EQ(land.features.count(), 1);
        int beside = 0;
        for (const Start& start : land.features.of(0)) {
            if (land.x(start) < 1200.0 || land.x(start) > 3800.0) continue;
            ++beside;
            const double away = std::abs(land.y(start) - 2560.0);
            ASSERT_NEAR(away, 200.0, 10.0 + land.graph.spacing);
        }
        EXPECT_GT(beside, samples / 2);
        EXPECT_FALSE(leads_out(land, 0, land.graph.node(samples / 2, samples / 2)));
    }
}

// ---- Costs

// The starts of `count` peaks with this cost.
std::vector<Start> costing(const CostRule& rule, int count = 200,
                           std::vector<Group> before = {}) {
    Group group = peaks(count);
    group.cost = rule;
    const int place = static_cast<int>(before.size());
    before.push_back(group);
    return Land(with(std::move(before)), 256).of_group(place);
}

float least_of(const std::vector<Start>& starts) {
    return std::ranges::min(starts, {}, &Start::cost).cost;
}
float greatest_of(const std::vector<Start>& starts) {
    return std::ranges::max(starts, {}, &Start::cost).cost;
}

TEST(Costs, NoiseIsOneFieldWithItsLeastOverTheLandAtZero) {
    const std::vector<Start> many = costing({}, 2000), few = costing({}, 5);
    EXPECT_LT(least_of(many), 8.0f);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(few[i].cost, many[i].cost);
    // Two groups at one place: the same cost.
    Group other = peaks(1, "other");
    std::get<Peaks>(other.where).placement.away = {};
    Pictures pictures;
    const Source point = pictures.svg("<rect x='99' y='99' width='3' height='3'/>");
    const Land land(with({group_of("a", Strokes{point, {}}), other,
                          group_of("b", Strokes{point, {}})}),
                    256);
    ASSERT_EQ(land.features.count(), 3);
    EXPECT_EQ(land.features.of(0)[0].cost, land.features.of(2)[0].cost);
}

TEST(Costs, RangeIsReachedAndKept) {
    for (const Kind kind : {Kind::kNoise, Kind::kRandom, Kind::kDistance}) {
        CostRule rule;
        rule.kind = kind;
        rule.range = {{metres(20.0), metres(30.0)}};
        const std::vector<Start> starts = costing(rule, 1000);
        EXPECT_TRUE(least_of(starts) >= 20.0f && least_of(starts) < 20.7f);
        EXPECT_TRUE(greatest_of(starts) > 29.0f && greatest_of(starts) <= 30.0f);
    }
}

TEST(Costs, ShareOfTheOwnMaximumIsEquation41) {
    const std::vector<Start> plain = costing({}, 2000);
    CostRule rule;
    rule.share = {{0.6, 0.85}};
    const std::vector<Start> shares = costing(rule, 2000);
    const double most = greatest_of(plain);  // of 2,000 places nearly of the land
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const double expected = 0.6 * most + 0.25 * plain[i].cost;
        EXPECT_NEAR(shares[i].cost, expected, 0.02 * most);
    }
}

TEST(Costs, ShareOfAGroupBefore) {
    Group cone = peaks(3, "cone");
    cone.cost = constant(100.0);
    CostRule rule;
    rule.share = {{1.5, 2.0}};
    rule.share_of = "cone";
    rule.less = metres(20.0);
    const std::vector<Start> starts = costing(rule, 500, {cone});
    EXPECT_TRUE(least_of(starts) >= 120.0f && least_of(starts) < 125.0f);
    EXPECT_TRUE(greatest_of(starts) > 155.0f && greatest_of(starts) <= 160.0f);
}

TEST(Costs, ShareOfTheApproximateCostUnderTheStroke) {
    Pictures pictures;
    const auto spot = [&](int x) {
        return pictures.svg("<rect x='" + std::to_string(x) +
                            "' y='255' width='2' height='2'/>");
    };
    Group peak = group_of("peak", Strokes{spot(100), {}});
    peak.cost = constant(300.0);
    Group crater = group_of("crater", Strokes{spot(110), {}});
    crater.cost = constant(0.0);
    crater.cost.range = {};
    crater.cost.share = {{1.0, 1.0}};
    crater.cost.share_of = "approximate";
    crater.cost.less = metres(50.0);
    Options options = with({peak, crater});
    options.edge_weight_deviation = 0.0;
    options.mean_edge_weight = 1.0;
    options.sea_level_scale = 2.0;
    // 100 m of path from the peak.
    EXPECT_NEAR(Land(options, 512).of_group(1)[0].cost, 300.0 + 100.0 - 50.0, 15.0);
    options.sea_level_scale = 1.1;  // no deeper than the sea
    EXPECT_NEAR(Land(options, 512).of_group(1)[0].cost, 330.0 - 50.0, 1e-3);
}

TEST(Costs, InvertedSwapsLeastAndGreatest) {
    CostRule rule;
    rule.range = {{metres(10.0), metres(30.0)}};
    const std::vector<Start> plain = costing(rule);
    rule.inverted = true;
    const std::vector<Start> inverted = costing(rule);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_NEAR(plain[i].cost + inverted[i].cost, 40.0f, 1e-3f);
    }
}

TEST(Costs, MinimumAndSum) {
    CostRule noise, distance, both;
    noise.range = {{metres(-10.0), metres(200.0)}};
    distance.kind = Kind::kDistance;
    distance.range = {{metres(0.0), metres(300.0)}};
    both.of = {noise, distance};
    both.kind = Kind::kSum;
    noise.range = {{metres(0.0), metres(210.0)}};  // a group's own costs are not negative
    const std::vector<Start> a = costing(noise), b = costing(distance),
                             sum = costing(both);
    both.kind = Kind::kMinimum;
    both.of[0].range = noise.range;
    const std::vector<Start> least = costing(both);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(sum[i].cost, std::max(0.0f, a[i].cost - 10.0f + b[i].cost), 1e-3f);
        EXPECT_EQ(least[i].cost, std::min(a[i].cost, b[i].cost));
    }
}

TEST(Costs, DistanceFromAPoint) {
    CostRule rule;
    rule.kind = Kind::kDistance;
    rule.range = {{metres(0.0), metres(100.0)}};
    rule.centre = {metres(1000.0), metres(4000.0)};  // from the south-west
    Group group = peaks(50);
    group.cost = rule;
    const Land land(with({group}), 1024);
    const double farthest = std::hypot(4120.0, 4000.0);
    for (const Start& start : land.features.starts) {
        const double away = std::hypot(land.x(start) - 1000.0, land.y(start) - 1120.0);
        EXPECT_NEAR(start.cost, 100.0 * away / farthest, 0.2);
    }
}

TEST(Costs, PaintedFromBlackToWhite) {
    Pictures pictures;
    CostRule rule;
    rule.kind = Kind::kPainted;
    rule.image = pictures.svg(
        "<rect width='512' height='512' fill='#fff'/>"
        "<rect width='256' height='512' fill='#000'/>");
    rule.range = {{metres(50.0), metres(150.0)}};
    Group group = peaks(50);
    group.cost = rule;
    const Land land(with({group}), 256);
    for (const Start& start : land.features.starts) {
        if (std::abs(land.x(start) - 2560.0) < 30.0) continue;
        EXPECT_NEAR(start.cost, land.x(start) < 2560.0 ? 50.0 : 150.0, 1e-3);
    }
}

TEST(Costs, OfTheTerrainSoFar) {
    Terrain terrain = flat(256, 256);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) terrain.heights(x, y) = static_cast<float>(y);
    }
    Group group = peaks(50);
    group.cost.kind = Kind::kTerrain;
    const Land land(with({group}), terrain);
    for (const Start& start : land.features.starts) {
        EXPECT_NEAR(start.cost, 255.0 - land.graph.y_of(start.node), 1.0);
    }
}

TEST(Costs, GaussianIsGreatestWhereTheStrokeBegins) {
    Pictures pictures;
    Group group = group_of("cone", Strokes{pictures.svg(line(100, 200, 400, 200)), {}});
    group.cost.kind = Kind::kGaussian;
    group.cost.range = {{metres(0.0), metres(400.0)}};
    const Land land(with({group}), 512);
    const double sigma = 2.0 * 3000.0 / 6.0;  // eq. 4.2
    for (const Start& start : land.features.starts) {
        const double t = (land.x(start) - 1000.0) / sigma;
        ASSERT_NEAR(start.cost, 400.0 * std::exp(-0.5 * t * t), 4.0);
    }
    EXPECT_NEAR(greatest_of(land.features.starts), 400.0, 1.0);
}

TEST(Costs, DrawnAlongTheStrokeFromItsWesternEnd) {
    Pictures pictures;
    // Drawn from the east: its western end is its beginning all the same.
    Group group = group_of("ridge", Strokes{pictures.svg(line(400, 300, 100, 100)), {}});
    group.cost.kind = Kind::kDrawn;
    group.cost.curve.points = {{0, 5}, {3, 5}, {6, 0}, {12, 10}};
    group.cost.range = {{metres(0.0), metres(100.0)}};
    for (const int samples : {256, 1024}) {
        const Land land(with({group}), samples);
        for (const Start& start : land.features.starts) {
            const double x = 12.0 * (land.x(start) - 1000.0) / 3000.0;
            const double f = x < 3 ? 5 : x < 6 ? 5 * (6 - x) / 3 : 10 * (x - 6) / 6;
            ASSERT_NEAR(start.cost, 100.0 - 10.0 * f, 2.5) << x;
        }
    }
}

TEST(Costs, DrawnAroundARingMeetsItself) {
    Pictures pictures;
    Group group = group_of(
        "ring", Strokes{pictures.svg("<circle cx='256' cy='256' r='100' fill='none' "
                                     "stroke='#000' stroke-width='2'/>"),
                        {}});
    group.cost.kind = Kind::kDrawn;
    group.cost.curve.points = {{0, 1}, {1, 0}};
    group.cost.range = {{metres(0.0), metres(100.0)}};
    const Land land(with({group}), 512);
    for (const Start& start : land.features.starts) {
        const double angle =
            std::atan2(std::abs(land.y(start) - 2560.0), 2560.0 - land.x(start));
        ASSERT_NEAR(start.cost, 100.0 * angle / 3.14159, 4.0);
    }
}

// ---- Ridges

TEST(RidgeGrowth, ExtendsTheFeatureItComesFrom) {
    Options options = with({peaks(4)});
    options.grain = metres(4.0 * kWidth / 96);  // the layout is this land's grid
    const Land bare(options, 96, 3);
    options.groups[0].ridges = {
        .count = 12, .cost_factor = 0.25, .reach = {}, .from = {}};
    const Land grown(options, 96, 3);
    ASSERT_EQ(grown.features.count(), 4);
    LeastCost paths(bare.graph);
    paths.spread(bare.features.starts, RawCostModel{bare.features.starts});
    std::size_t nodes = 0;
    for (int f = 0; f < 4; ++f) {
        for (const Start& start : grown.features.of(f)) {
            EXPECT_EQ(paths[start.node].origin, f);
            EXPECT_NEAR(start.cost, 0.25f * paths[start.node].cost, 1e-3f);
            ++nodes;
        }
    }
    EXPECT_GT(nodes, 100u);
}

TEST(RidgeGrowth, KeepsWithinItsReach) {
    Pictures pictures;
    Group lip = group_of("lip", Strokes{pictures.svg(line(100, 256, 400, 256)), {}});
    const Land bare(with({lip}), 512);
    lip.ridges = {.count = 75, .cost_factor = 0.35, .reach = metres(400.0), .from = {}};
    const Land land(with({lip}), 512);
    EXPECT_GT(land.features.starts.size(), bare.features.starts.size() + 500);
    double most = 0.0;
    for (const Start& start : land.features.starts) {
        most = std::max(most, land.distance_to(bare.features.starts, start));
    }
    EXPECT_TRUE(most > 300.0 && most < 425.0) << most;
}

TEST(RidgeGrowth, TakesTheSameWayAtEveryResolution) {
    Options options = with({peaks(6)});
    options.groups[0].ridges.count = 10;
    const Land fine(options, 1024);
    for (const int samples : {256, 512}) {
        const Land land(options, samples);
        std::set<int> seen, expected;
        for (const Start& s : land.features.starts) seen.insert(s.node);
        for (const Start& s : fine.features.starts) {
            const int parts = 1024 / samples;
            expected.insert(land.graph.node(fine.graph.x_of(s.node) / parts,
                                            fine.graph.y_of(s.node) / parts));
        }
        std::vector<int> both;
        std::ranges::set_intersection(seen, expected, std::back_inserter(both));
        EXPECT_GT(10 * both.size(), 9 * seen.size()) << samples;
    }
}

TEST(RidgeGrowth, IsWholeOnAFinerGrid) {
    Options options = with({peaks(1)});
    options.groups[0].ridges.count = 1;
    const Land land(options, 2048);
    const auto ridge = land.features.of(0).subspan(1);
    ASSERT_GT(ridge.size(), 40u);
    for (std::size_t i = 1; i < ridge.size(); ++i) {
        const int x = land.graph.x_of(ridge[i].node) - land.graph.x_of(ridge[i - 1].node);
        const int y = land.graph.y_of(ridge[i].node) - land.graph.y_of(ridge[i - 1].node);
        ASSERT_LE(std::max(std::abs(x), std::abs(y)), 1);
    }
}

TEST(RidgeGrowth, FromOtherGroupsJoinsTheirFeatures) {
    Group hills = peaks(4, "hills");
    hills.ridges = {.count = 5, .cost_factor = 0.5, .reach = {}, .from = {"ranges"}};
    const Land land(with({peaks(2, "ranges"), hills}), 256);
    EXPECT_GT(land.of_group(0).size(), 20u);
    EXPECT_EQ(land.of_group(1).size(), 4u);
}

// ---- Sides

Options two_sided(const Source& image) {
    Options options;
    options.profiles.resize(3);
    options.profiles[0].name = "cliff";
    options.profiles[1].name = "plain";
    options.profiles[2].name = "scree";
    Group group = group_of("rim", Strokes{image, {}});
    group.profile = {"scree", "cliff"};
    group.other_side = "plain";
    options.groups = {group};
    return options;
}

TEST(Sides, ProfilesAreTakenInTurn) {
    Pictures pictures;
    const Land land(
        two_sided(pictures.svg(line(50, 100, 400, 100) + line(50, 200, 400, 200) +
                               line(50, 300, 400, 300))),
        256);
    const auto& features = land.features.features;
    EXPECT_EQ((std::array{features[0].profile, features[1].profile, features[2].profile}),
              (std::array{2, 0, 2}));
    EXPECT_EQ(features[1].other_side, 1);
    const Land plain(with({peaks(2)}), 64);
    EXPECT_EQ(plain.features.features[0].profile, -1);
    EXPECT_EQ(plain.features.features[0].other_side, -1);
    EXPECT_TRUE(plain.features.sides.empty());
}

TEST(Sides, NorthOfALineDrawnEitherWay) {
    Pictures pictures;
    for (const auto& drawn : {line(50, 200, 400, 200), line(400, 200, 50, 200)}) {
        const Land land(two_sided(pictures.svg(drawn)), 512);
        ASSERT_EQ(land.features.sides.size(), land.features.starts.size());
        for (const auto& [east, south] : land.features.sides) {
            ASSERT_NEAR(std::hypot(east, south), 1.0, 1e-5);
            ASSERT_LT(south, -0.98f);
        }
    }
    // From its northern end, if both lie as far west: the left is east.
    const Land upright(two_sided(pictures.svg(line(200, 50, 200, 400))), 512);
    for (const auto& [east, south] : upright.features.sides) ASSERT_GT(east, 0.98f);
}

TEST(Sides, WhereAStrokeTurnsBack) {
    Pictures pictures;
    // A hairpin, its limbs four thesis units apart, from the north-west round to the
    // west.
    const Land land(two_sided(pictures.svg("<path d='M100 100 H300 V104 H102' "
                                           "fill='none' stroke='#000'/>")),
                    512);
    for (std::size_t i = 0; i < land.features.starts.size(); ++i) {
        const double x = land.x(land.features.starts[i]);
        const double y = land.y(land.features.starts[i]);
        if (x > 2800.0) continue;
        const float south = land.features.sides[i][1];
        if (y < 1015.0) {
            ASSERT_LT(south, -0.8f) << x;
        } else if (y > 1025.0) {
            ASSERT_GT(south, 0.8f) << x;
        }
    }
}

TEST(Sides, IntoAClosedRing) {
    Pictures pictures;
    const Source ring = pictures.svg(
        "<circle cx='256' cy='256' r='80' fill='none' stroke='#000' stroke-width='3'/>");
    Options circle = two_sided(ring);
    circle.groups[0].where = std::get<Circles>(circles(1, 400.0, 400.0, 0.1).where);
    circle.groups[0].name = "circles";
    for (const bool drawn : {true, false}) {
        const Land land(drawn ? two_sided(ring) : circle, 512);
        Start middle{land.graph.node(256, 256), 0.0f};
        if (!drawn) middle = centres(1, land)[0];
        for (std::size_t i = 0; i < land.features.starts.size(); ++i) {
            const Start& start = land.features.starts[i];
            const double x = land.x(middle) - land.x(start);
            const double y = land.y(middle) - land.y(start);
            const auto [east, south] = land.features.sides[i];
            ASSERT_GT((east * x + south * y) / std::hypot(x, y), 0.9);
        }
    }
}

// ---- Bad input

TEST(FeaturesRefuse, NoFeature) {
    expect_refused({}, "no features");
    expect_refused(with({peaks(0)}), "no features");
}

TEST(FeaturesRefuse, NoRoom) {
    Group group = peaks(40, "hills");
    Placement& placement = std::get<Peaks>(group.where).placement;
    placement.apart = metres(2000.0);
    expect_refused(with({group}), "group 'hills': found room for ");
    placement.apart = {};
    Pictures pictures;
    placement.keep_out = pictures.svg("<rect width='512' height='512'/>");
    expect_refused(with({group}), "group 'hills': found room for 0 of 40 features");
}

TEST(FeaturesRefuse, MoreThanMemoryAllows) {
    expect_refused(with({peaks(2000000000)}), "GiB");
    Group dense = peaks(0);
    std::get<Peaks>(dense.where).placement.density = 1e300;
    expect_refused(with({dense}), "GiB");
}

TEST(FeaturesRefuse, NumbersOutOfRange) {
    expect_refused(with({peaks(-1)}), "count is -1");
    expect_refused(with({circles(1, 50.0, 20.0, 0.0)}), "radius is from 50 m to 20 m");
    expect_refused(with({circles(1, 0.0, 20.0, 0.0)}), "radius");
    expect_refused(with({circles(1, 10.0, 9000.0, 0.0)}), "at most");
    expect_refused(with({circles(1, 10.0, 20.0, 1.0)}), "roughness is 1");
    Group group = peaks(3);
    Placement& placement = std::get<Peaks>(group.where).placement;
    placement.density = 1.0;
    expect_refused(with({group}), "not both");
    placement.count = 0;
    placement.density = -1.0;
    expect_refused(with({group}), "density is -1");
    group = peaks(3);
    std::get<Peaks>(group.where).placement.apart = metres(-5.0);
    expect_refused(with({group}), "apart is -5 m");
    group = peaks(3);
    group.ridges.count = -1;
    expect_refused(with({group}), "ridges.count is -1");
    group.ridges = {.count = 1, .cost_factor = -1.0, .reach = {}, .from = {}};
    expect_refused(with({group}), "cost_factor is -1");
}

TEST(FeaturesRefuse, ColoursWithoutRuleAndRulesWithoutColour) {
    Field<Rgb8> pixels(64, 64, kWhite);
    for (int x = 0; x < 60; ++x) pixels(x, 20) = kRed, pixels(x, 40) = {0, 255, 0};
    Pictures pictures;
    const Source source = pictures.png(pixels);
    const Group red = group_of("red", Strokes{source, {{255, 0, 0}}});
    expect_refused(with({red}), "colour #00ff00 of picture0.png has no group");
    expect_refused(with({red, group_of("green", Strokes{source, {{0, 255, 0}}}),
                         group_of("blue", Strokes{source, {{0, 0, 255}}})}),
                   "group 'blue': no stroke of picture0.png has its colour, #0000ff");
}

TEST(FeaturesRefuse, GroupsThatAreNotBefore) {
    Group group = peaks(3, "hills");
    std::get<Peaks>(group.where).placement.away = {{"later", metres(10.0)}};
    expect_refused(with({group, peaks(3, "later")}), "group 'hills': away.from");
    group = peaks(3, "hills");
    group.cost.share = {{0.0, 1.0}};
    group.cost.share_of = "later";
    expect_refused(with({group, peaks(3, "later")}), "group 'hills': share_of");
    group.cost.share_of = "approximate";
    expect_refused(with({group}), "approximate");
    group = peaks(3, "hills");
    group.ridges = {.count = 1, .cost_factor = 0.5, .reach = {}, .from = {"later"}};
    expect_refused(with({group, peaks(3, "later")}), "group 'hills': ridges.from");
    expect_refused(with({peaks(1, "a"), peaks(1, "a")}), "two groups are named 'a'");
}

TEST(FeaturesRefuse, RidgesThatFindNoNode) {
    Group group = peaks(1, "hills");
    group.ridges = {.count = 2, .cost_factor = 0.5, .reach = metres(1.0), .from = {}};
    expect_refused(with({group}), "group 'hills': found a node for 0 of 2 ridges");
    group = peaks(0, "hills");
    group.ridges.count = 2;
    expect_refused(with({group}), "no feature for its ridges");
}

TEST(FeaturesRefuse, CostRulesThatContradictThemselves) {
    const auto refused = [](CostRule rule, const std::string& words) {
        Group group = peaks(3);
        group.cost = std::move(rule);
        expect_refused(with({group}), words);
    };
    CostRule rule;
    rule.range = {{metres(0.0), metres(1.0)}};
    rule.share = {{0.0, 1.0}};
    refused(rule, "not both");
    rule = {};
    rule.share_of = "peaks";
    refused(rule, "share_of needs a share");
    rule = {};
    rule.kind = Kind::kSum;
    refused(rule, "need rules");
    rule.kind = Kind::kPainted;
    refused(rule, "painted needs an image");
    rule.kind = Kind::kDrawn;
    refused(rule, "drawn needs a curve");
}

TEST(FeaturesRefuse, LevelsAndDistancesWithoutGround) {
    Pictures pictures;
    Terraces terraces;
    terraces.image = pictures.svg(line(0, 256, 512, 256));
    const auto refused = [&](std::vector<Terraces::Level> levels,
                             const std::string& words) {
        terraces.levels = std::move(levels);
        expect_refused(with({group_of("steps", terraces)}), words);
    };
    refused({}, "no level; add one");
    refused({{{0.5, 0.5}, {}}}, "terrace 1 is from 0.5 to 0.5");
    refused({{{0.2, 0.5}, {}}, {{0.4, 0.9}, {}}}, "terrace 2 reaches 0.9");
    refused({{{0.9999999, 0.99999999}, {}}}, "no ground lies in terrace 1");
    expect_refused(with({group_of("lip", Lip{terraces.image, metres(1e6)})}),
                   "group 'lip': no ground lies");
    expect_refused(with({group_of("lip", Lip{terraces.image, metres(0.0)})}),
                   "distance is 0 m");
}

TEST(FeaturesRefuse, PicturesWithoutEdges) {
    Pictures pictures;
    expect_refused(
        with({group_of("e", Edges{pictures.png(Field<Rgb8>(16, 16, kRed)), 0.5})}),
        "has no edges");
    expect_refused(with({group_of("e", Edges{pictures.png(square(16, 4, 8)), 0.0})}),
                   "threshold is 0");
}

TEST(FeaturesRefuse, ProfilesThatAreNotThere) {
    Group group = peaks(1);
    group.profile = {"mesa"};
    expect_refused(with({group}), "no profile is named 'mesa'");
    Options options = with({group});
    options.profiles.resize(1);
    options.profiles[0].name = "mesa";
    options.groups[0].other_side = "mesa";
    expect_refused(options, "other_side needs strokes");
}

}  // namespace
}  // namespace cydonia::distance
