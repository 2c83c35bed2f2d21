#include "synth/distance/dijkstra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <queue>
#include <set>
#include <tuple>

#include "field/error.h"
#include "field/random.h"
#include "synth/distance/cost_model.h"

namespace cydonia::distance {
namespace {

// The algorithm of textbooks on the whole graph, with the standard queue.
template <class CostModel>
std::vector<Label> reference(const Graph& graph, std::span<const Start> starts,
                             const CostModel& model) {
    std::vector<Label> labels(static_cast<std::size_t>(graph.nodes()));
    using Entry = std::pair<float, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for (std::size_t i = 0; i < starts.size(); ++i) {
        Label& label = labels[starts[i].node];
        if (starts[i].cost >= label.cost) continue;
        label = model.begin(static_cast<int>(i));
        label.origin = static_cast<int>(i);
        queue.push({label.cost, starts[i].node});
    }
    std::set<int> settled;
    while (!queue.empty()) {
        const auto [cost, node] = queue.top();
        queue.pop();
        if (!settled.insert(node).second) continue;
        const Label tail = labels[node];
        for (int d = 0; d < graph.directions; ++d) {
            const int next = node + graph.step[d];
            const int x = graph.x_of(next), y = graph.y_of(next);
            if (x < 0 || y < 0 || x >= graph.width || y >= graph.height) continue;
            Label reached =
                model.from(node, tail)(d, next, tail.length + graph.edge(node, d));
            reached.origin = tail.origin;
            reached.direction = static_cast<std::uint8_t>(d);
            const auto rank = [](const Label& l) {
                return std::tuple(l.cost, l.origin, l.length, l.direction);
            };
            if (rank(reached) < rank(labels[next])) {
                if (reached.cost < labels[next].cost) queue.push({reached.cost, next});
                labels[next] = reached;
            }
        }
    }
    return labels;
}

std::vector<Start> random_starts(const Graph& graph, int count, double highest,
                                 std::uint64_t seed) {
    std::vector<Start> starts;
    for (int i = 0; i < count; ++i) {
        const auto draw = [&](const char* what) {
            return unit(hash_of({seed, key(what), static_cast<std::uint64_t>(i)}));
        };
        starts.push_back({graph.node(static_cast<int>(draw("x") * graph.width),
                                     static_cast<int>(draw("y") * graph.height)),
                          static_cast<float>(highest * draw("cost"))});
    }
    return starts;
}

template <class CostModel>
void expect_same_as_reference(const Graph& graph, std::span<const Start> starts,
                              const CostModel& model, LeastCost& paths) {
    paths.spread(starts, model);
    const std::vector<Label> expected = reference(graph, starts, model);
    for (int y = 0; y < graph.height; ++y) {
        for (int x = 0; x < graph.width; ++x) {
            const int node = graph.node(x, y);
            ASSERT_EQ(paths[node].cost, expected[node].cost) << x << ", " << y;
            ASSERT_EQ(paths[node].origin, expected[node].origin) << x << ", " << y;
            ASSERT_EQ(paths[node].direction, expected[node].direction) << x << ", " << y;
        }
    }
    EXPECT_EQ(paths.settled().size(),
              static_cast<std::size_t>(graph.width * graph.height));
}

// `count` profiles' descents from cost 0 to sea level, of very different shapes.
Shapes some_shapes(const Graph& graph, std::size_t starts, double sea_level) {
    Shapes shapes;
    shapes.sea_level = sea_level;
    shapes.mean_edge_weight = 2.0;
    Profile cone, mesa, scree;
    cone.curve.points = {{0, 1}, {40, 0}};
    mesa.curve.points = {{0, 1}, {10, 0.99}, {11, 0.2}, {30, 0.19}, {32, 0}};
    scree.curve.points = {{0, 1}, {2, 0.6}, {10, 0.3}, {40, 0.1}, {90, 0}};
    for (const Profile& profile : {cone, mesa, scree}) {
        shapes.descents.push_back(
            descent_of(profile, sea_level, 2.0, 0.001, graph.width * graph.spacing));
    }
    for (std::size_t i = 0; i < starts; ++i) {
        shapes.ways.push_back(static_cast<std::uint8_t>(mix(i) % 3));
    }
    return shapes;
}

TEST(BucketQueue, GivesBucketsInOrderAndEachEntryOnce) {
    BucketQueue queue;
    for (float width : {0.25f, 1.0f, 1e3f}) {
        queue.reset(width);
        std::uint64_t draws = 0;
        std::multiset<int> waiting;
        const auto push_above = [&](float least) {
            const float cost = least + width + static_cast<float>(mix(++draws) % 300);
            const auto node = static_cast<int>(draws);
            queue.push(cost, cost, node);
            waiting.insert(node);
        };
        for (int i = 0; i < 200; ++i) push_above(0.0f);
        float before = 0.0f;
        queue.drain([&](BucketQueue::Entry entry, BucketQueue::Entry) {
            ASSERT_GT(entry.cost, before - 1.001f * width);
            before = std::max(before, entry.cost);
            ASSERT_EQ(waiting.erase(entry.node), 1u);
            if (draws < 8000) push_above(entry.cost);
        });
        EXPECT_TRUE(waiting.empty());
    }
}

TEST(LeastCost, EqualsReferenceOnRandomGraphs) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Graph graph = graph_of(61, 47, 10.0,
                                     {.mean = 2.0,
                                      .deviation = seed % 3 == 0 ? 0.0 : 1.99,
                                      .grain = 25.0,
                                      .neighbours = seed % 2 ? 8 : 16},
                                     seed);
        LeastCost paths(graph);
        for (int count : {1, 7, 60}) {
            const auto starts = random_starts(graph, count, 500.0, seed);
            expect_same_as_reference(graph, starts, RawCostModel{starts}, paths);
        }
    }
}

TEST(LeastCost, EqualsReferenceWithAFactorForEachStart) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Graph graph =
            graph_of(50, 50, 10.0, {.mean = 2.0, .deviation = 1.5, .grain = 40.0}, seed);
        LeastCost paths(graph);
        const auto starts = random_starts(graph, 40, 3000.0, seed);
        std::vector<float> factors;
        for (std::size_t i = 0; i < starts.size(); ++i) {
            // Costs so far apart that steps leave the queue's ring.
            const double power = 4.0 * unit(hash_of({seed, i})) - 2.0;
            factors.push_back(static_cast<float>(std::pow(10.0, power)));
        }
        expect_same_as_reference(graph, starts, ConstantCostModel{starts, factors},
                                 paths);
    }
}

TEST(LeastCost, EqualsReferenceAlongProfiles) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Graph graph = graph_of(
            70, 50, 10.0,
            {.mean = 2.0, .deviation = 1.5, .neighbours = seed % 2 ? 8 : 16}, seed);
        LeastCost paths(graph);
        for (int count : {1, 9, 60}) {
            const auto starts = random_starts(graph, count, 80.0, seed);
            const Shapes shapes = some_shapes(graph, starts.size(), 100.0);
            expect_same_as_reference(graph, starts, ProfileCostModel(shapes, starts, 0),
                                     paths);
        }
    }
}

TEST(LeastCost, EqualsReferenceWhereProfilesChange) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Graph graph = graph_of(60, 60, 10.0, {.mean = 2.0, .deviation = 1.0}, seed);
        LeastCost paths(graph);
        const auto starts = random_starts(graph, 12, 80.0, seed);
        Shapes shapes = some_shapes(graph, starts.size(), 100.0);
        std::vector<std::array<float, 2>> sides(starts.size(), {0.0f, -1.0f});
        for (std::size_t i = 0; i < starts.size(); ++i) {
            shapes.other_ways.push_back(static_cast<std::uint8_t>(mix(i + 7) % 3));
            shapes.feature_of.push_back(static_cast<int>(i));
        }
        lay_sides(shapes, graph, starts, sides);
        shapes.way_at.assign(static_cast<std::size_t>(graph.nodes()), Shapes::kOwn);
        for (int y = 20; y < 40; ++y)
            for (int x = 10; x < 50; ++x) shapes.way_at[graph.node(x, y)] = 2;
        shapes.region_ways = {2};
        expect_same_as_reference(graph, starts, ChangingCostModel(shapes, starts, 0),
                                 paths);
    }
}

TEST(LeastCost, GoesOnAtTheSameHeightInARegion) {
    // A cone of slope 1, in the eastern half of slope 3.
    const Graph graph = graph_of(101, 21, 10.0, {.mean = 2.0, .deviation = 0.0}, 1);
    const std::vector<Start> starts{{graph.node(20, 10), 0.0f}};
    Shapes shapes{
        .sea_level = 1000.0, .mean_edge_weight = 2.0, .ways = {0}, .region_ways = {1}};
    for (double reach : {1000.0, 1000.0 / 3.0}) {
        Profile straight;
        straight.curve.points = {{0, 1}, {1, 0}};
        straight.reach = metres(reach);
        shapes.descents.push_back(descent_of(straight, 1000.0, 2.0, 0.001, 1010.0));
    }
    shapes.way_at.assign(static_cast<std::size_t>(graph.nodes()), Shapes::kOwn);
    for (int y = 0; y < 21; ++y)
        for (int x = 51; x < 101; ++x) shapes.way_at[graph.node(x, y)] = 1;
    LeastCost paths(graph);
    paths.spread(starts, ChangingCostModel(shapes, starts, 0));
    EXPECT_NEAR(paths[graph.node(50, 10)].cost, 300.0, 0.5);
    EXPECT_NEAR(paths[graph.node(60, 10)].cost, 300.0 + 300.0, 1.0);
    EXPECT_NEAR(paths[graph.node(10, 10)].cost, 100.0, 0.5);
}

TEST(LeastCost, HasAProfileOnEachSideOfAStroke) {
    // A stroke one cell thin that climbs in steps from west to east: slope 1 to its
    // north, 3 to its south. Its generators differ in cost by less than either falls.
    const Graph graph = graph_of(61, 61, 10.0, {.mean = 2.0, .deviation = 0.5}, 1);
    std::vector<Start> starts;
    std::vector<std::array<float, 2>> sides;
    Shapes shapes{.sea_level = 1000.0, .mean_edge_weight = 2.0};
    const auto stroke = [](int x) { return 38 - x / 4; };
    for (int x = 2; x < 59; ++x) {
        starts.push_back({graph.node(x, stroke(x)), x % 7 == 0 ? 0.0f : 20.0f});
        sides.push_back({-0.2425f, -0.9701f});
        shapes.ways.push_back(0);
        shapes.other_ways.push_back(1);
        shapes.feature_of.push_back(0);
    }
    for (double reach : {1000.0, 1000.0 / 3.0}) {
        Profile straight;
        straight.curve.points = {{0, 1}, {1, 0}};
        straight.reach = metres(reach);
        shapes.descents.push_back(descent_of(straight, 1000.0, 2.0, 0.001, 610.0));
    }
    lay_sides(shapes, graph, starts, sides);
    LeastCost paths(graph);
    paths.spread(starts, ChangingCostModel(shapes, starts, 0));
    for (int x = 10; x < 50; ++x) {
        const float north = paths[graph.node(x, stroke(x) - 10)].cost;
        const float south = paths[graph.node(x, stroke(x) + 10)].cost;
        EXPECT_GT(north, 40.0f) << x;
        EXPECT_LT(north, 160.0f) << x;
        EXPECT_GT(south, 1.8f * north) << x;
    }
}

TEST(LeastCost, OneStartIsThePolygonalConeOfTheMetric) {
    using Metric = Options::Metric;
    struct Case {
        Metric metric;
        int neighbours;
    };
    for (const Case& c : {Case{Metric::kEuclidean, 8}, Case{Metric::kEuclidean, 16},
                          Case{Metric::kThesis, 8}}) {
        const Graph graph = graph_of(41, 33, 10.0,
                                     {.mean = 2.0,
                                      .deviation = 0.0,
                                      .metric = c.metric,
                                      .neighbours = c.neighbours},
                                     1);
        const std::vector<Start> starts{{graph.node(12, 20), 5.0f}};
        LeastCost paths(graph);
        paths.spread(starts, RawCostModel{starts});
        for (int y = 0; y < graph.height; ++y) {
            for (int x = 0; x < graph.width; ++x) {
                const double a = std::max(std::abs(x - 12), std::abs(y - 20));
                const double b = std::min(std::abs(x - 12), std::abs(y - 20));
                double cells = a;  // kThesis: a square pyramid
                if (c.metric == Metric::kEuclidean && c.neighbours == 8) {
                    cells = a - b + std::sqrt(2.0) * b;  // octagon
                } else if (c.neighbours == 16) {
                    // Knight's moves, then straight or diagonal ones: 16-gon.
                    cells = a >= 2.0 * b ? a - 2.0 * b + std::sqrt(5.0) * b
                                         : std::sqrt(5.0) * (a - b) +
                                               std::sqrt(2.0) * (2.0 * b - a);
                }
                EXPECT_NEAR(paths[graph.node(x, y)].cost, 5.0 + 20.0 * cells, 1e-3);
            }
        }
    }
}

TEST(LeastCost, StopsWhereItIsTold) {
    const Graph graph = graph_of(60, 60, 1.0, {.mean = 1.0, .deviation = 0.5}, 3);
    const std::vector<Start> starts{{graph.node(30, 30), 0.0f}};
    LeastCost paths(graph);
    paths.spread(starts, RawCostModel{starts},
                 [](int, float cost) { return cost < 10.0f; });
    const std::vector<Label> all = reference(graph, starts, RawCostModel{starts});
    std::size_t reached = 0;
    for (int node = 0; node < graph.nodes(); ++node) {
        if (all[node].cost < 10.0f) {
            EXPECT_EQ(paths[node].cost, all[node].cost);
        }
        if (std::isfinite(paths[node].cost)) ++reached;
    }
    EXPECT_EQ(paths.settled().size(), reached);
    EXPECT_LT(reached, 2000u);
}

TEST(LeastCost, PathBackAddsUpToItsCost) {
    const Graph graph = graph_of(80, 80, 10.0, {.mean = 2.0, .deviation = 1.0}, 5);
    const auto starts = random_starts(graph, 5, 300.0, 2);
    LeastCost paths(graph);
    paths.spread(starts, RawCostModel{starts});
    const std::vector<int> path = path_back(graph, paths, graph.node(3, 71));
    const Label& end = paths[path.front()];
    EXPECT_EQ(path.back(), starts[end.origin].node);
    double cost = starts[end.origin].cost;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const int step = path[i] - path[i + 1];
        int direction = 0;
        while (graph.step[direction] != step) ++direction;
        cost += graph.edge(path[i + 1], direction);
    }
    EXPECT_NEAR(cost, end.cost, 1e-2);
}

TEST(Graph, WeightsAreUniformAndPositive) {
    // Nodes far finer than the grain: an edge's weight is the noise itself.
    const Graph graph =
        graph_of(600, 600, 1.0, {.mean = 2.0, .deviation = 1.9, .grain = 20.0}, 5);
    std::array<int, 10> counts{};
    for (int y = 0; y < 600; ++y) {
        for (int x = 0; x < 600; ++x) {
            const double v = (graph.edge(graph.node(x, y), 0) - 2.0) / 1.9;
            ASSERT_GE(v, -1.0);
            ASSERT_LE(v, 1.0);
            ++counts[std::min(9, static_cast<int>(5.0 * (v + 1.0)))];
        }
    }
    for (int count : counts) EXPECT_NEAR(count, 36000, 3600);
}

TEST(Graph, EdgesAreTheMeanOfTheirParts) {
    const EdgeOptions options{.mean = 2.0, .deviation = 1.0, .grain = 40.0};
    const Graph coarse = graph_of(40, 40, 30.0, options, 8);
    const Graph fine = graph_of(120, 120, 10.0, options, 8);
    for (int y = 0; y < 39; ++y) {
        for (int x = 1; x < 39; ++x) {
            for (int d = 0; d < 4; ++d) {
                float sum = 0.0f;
                int node = fine.node(3 * x + 1, 3 * y + 1);
                for (int i = 0; i < 3; ++i) {
                    sum += fine.edge(node, d);
                    node += fine.step[d];
                }
                EXPECT_NEAR(coarse.edge(coarse.node(x, y), d), sum, 0.04 * sum);
            }
        }
    }
}

TEST(Graph, RefusesWeightsThatCouldVanish) {
    EXPECT_THROW(graph_of(8, 8, 1.0, {.mean = 2.0, .deviation = 2.0}, 1), Error);
    EXPECT_THROW(graph_of(8, 8, 1.0, {.mean = 0.0, .deviation = 0.0}, 1), Error);
    EXPECT_THROW(graph_of(8, 8, 1.0, {.mean = 2.0, .deviation = -0.1}, 1), Error);
    EXPECT_THROW(graph_of(8, 8, 1.0, {.grain = 0.0}, 1), Error);
    EXPECT_THROW(graph_of(8, 8, 1.0, {.neighbours = 4}, 1), Error);
    EXPECT_THROW(
        graph_of(8, 8, 1.0, {.metric = Options::Metric::kThesis, .neighbours = 16}, 1),
        Error);
}

}  // namespace
}  // namespace cydonia::distance
