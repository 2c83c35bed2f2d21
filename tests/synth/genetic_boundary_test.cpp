// Boundary refinement (Saunders 2006, IV.3.1 and VI.1).
#include "synth/genetic/map/boundary.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "field/random.h"
#include "synth/genetic/map/outlines.h"

namespace cydonia::genetic {
namespace {

constexpr double kPi = std::numbers::pi;

StraightBoundary boundary(double length, double smoothness, double angle = 0.4) {
    const Point2 from{1234.5, -77.25};
    return {
        .from = from,
        .to = {from[0] + length * std::cos(angle), from[1] + length * std::sin(angle)},
        .smoothness = smoothness,
        .envelope = 0.25 * length,
        .free_at = {kPi, kPi},
        .course = {},
        .segment = 10.0};
}

// Along a boundary and across it, shares of its length.
Point2 local(const StraightBoundary& b, const Point2& p) {
    const double dx = b.to[0] - b.from[0], dy = b.to[1] - b.from[1],
                 square = dx * dx + dy * dy, px = p[0] - b.from[0], py = p[1] - b.from[1];
    return {(px * dx + py * dy) / square, (py * dx - px * dy) / square};
}

double size(const Point2& a, const Point2& b) {
    return std::hypot(b[0] - a[0], b[1] - a[1]);
}

// Mean turn from segment to segment.
double bend(const std::vector<Point2>& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
        sum += std::abs(std::remainder(
            std::atan2(line[i + 1][1] - line[i][1], line[i + 1][0] - line[i][0]) -
                std::atan2(line[i][1] - line[i - 1][1], line[i][0] - line[i - 1][0]),
            2.0 * kPi));
    return sum / double(line.size() - 2);
}

TEST(Boundary, ShortOnesStayStraight) {
    StraightBoundary b = boundary(9.0, 0.1);
    EXPECT_EQ(refined(b, 1), (std::vector<Point2>{b.from, b.to}));
    b.to = b.from;
    EXPECT_EQ(refined(b, 1).size(), 2u);
}

// Sections IV.3.1.1 and VI.1.3, for many of them.
TEST(Boundary, KeepsToItsLimits) {
    for (const double length : {15.0, 130.0, 2000.0, 15000.0})
        for (const double s : {0.0, 0.1, 0.5, 0.9, 1.0})
            for (std::uint64_t seed = 0; seed < (length > 1e4 ? 5u : 40u); ++seed) {
                StraightBoundary b = boundary(length, s, 2.0 * kPi * unit(mix(seed)));
                b.envelope = (0.05 + 0.3 * unit(mix(seed + 1))) * length;
                b.free_at = {0.05 + kPi * unit(mix(seed + 2)),
                             0.05 + kPi * unit(mix(seed + 3))};
                const auto line = refined(b, seed);
                ASSERT_EQ(line.front(), b.from);
                ASSERT_EQ(line.back(), b.to);
                ASSERT_FALSE(crosses_itself(line)) << length << ' ' << s << ' ' << seed;
                for (std::size_t i = 1; i < line.size(); ++i)
                    ASSERT_LE(size(line[i - 1], line[i]), b.segment);
                for (const Point2& p : line) {
                    const auto [x, y] = local(b, p);
                    ASSERT_LE(std::abs(y) * length, b.envelope + 1e-6);
                    // Within half of what is free at its ends.
                    for (const auto& [along, free] :
                         {std::pair{x, b.free_at[0]}, {1.0 - x, b.free_at[1]}}) {
                        const double steepest = free < kPi ? std::tan(0.5 * free) : 1e9;
                        ASSERT_LE(std::abs(y), steepest * along + 1e-6)
                            << length << ' ' << s << ' ' << seed;
                    }
                }
            }
}

// A boundary of thousands of segments is no straight line either.
TEST(Boundary, LongOnesAreRefinedToo) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const auto line = refined(boundary(50000.0, 0.3), seed);
        EXPECT_GE(line.size(), 5000u);
        EXPECT_LT(line.size(), 40000u);
    }
}

// Figures VI.1 and VI.2.
TEST(Boundary, SmoothOnesBendLess) {
    double smooth = 0.0, middle = 0.0, rough = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        smooth += bend(refined(boundary(1000.0, 0.9), seed));
        middle += bend(refined(boundary(1000.0, 0.4), seed));
        rough += bend(refined(boundary(1000.0, 0.1), seed));
    }
    EXPECT_LT(smooth, 0.5 * rough);
    EXPECT_LT(smooth, middle);
    EXPECT_LT(middle, rough);
}

// It runs into its corners as it is asked to.
TEST(Boundary, TakesItsCourseAtItsEnds) {
    double off = 0.0, straight = 0.0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        StraightBoundary b = boundary(120.0, 0.7, 0.0);
        b.course = {0.5, -0.5};
        const auto line = refined(b, seed);
        const double first = std::atan2(line[1][1] - line[0][1], line[1][0] - line[0][0]);
        off += std::abs(first - b.course[0]);
        straight += std::abs(first);
    }
    EXPECT_LT(off, 0.5 * straight);
}

TEST(Boundary, IsMadeByItsSeed) {
    const StraightBoundary b = boundary(500.0, 0.3);
    EXPECT_EQ(refined(b, 3), refined(b, 3));
    EXPECT_NE(refined(b, 3), refined(b, 4));
}

TEST(Boundary, CrossingsAreFound) {
    EXPECT_TRUE(crosses_itself({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
    EXPECT_FALSE(crosses_itself({{0, 0}, {2, 2}, {2, 0}}));
    EXPECT_FALSE(crosses_itself({{0, 0}, {2, 2}, {2, 0}, {0, 0}}));
    EXPECT_TRUE(crosses_itself({{0, 0}, {4, 0}, {4, 2}, {2, 0}}));  // touches
    EXPECT_FALSE(crosses_itself({}));
}

bool cross(const std::vector<Point2>& one, const std::vector<Point2>& other) {
    // As one line, without what joins them: ends that are the same are no crossing.
    const auto side = [](const Point2& o, const Point2& a, const Point2& b) {
        return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    };
    for (std::size_t i = 0; i < one.size(); ++i)
        for (std::size_t j = 0; j < other.size(); ++j) {
            const Point2 &a = one[i], &b = one[(i + 1) % one.size()], &c = other[j],
                         &d = other[(j + 1) % other.size()];
            if (side(a, b, c) * side(a, b, d) < 0.0 &&
                side(c, d, a) * side(c, d, b) < 0.0)
                return true;
        }
    return false;
}

// Sharp corners, thin regions: the regions' refined outlines cross neither themselves nor
// each other.
TEST(Outlines, NeverCross) {
    LibraryOptions library;
    library.types = {{.name = "a", .examples = {}}};
    const Extent extent{60, 60, 10.0};
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        // A fan of triangles around a corner, unevenly wide, and one thin one far out.
        MapOptions map;
        map.window = {0.0, 0.0, 600.0, 600.0};
        map.smoothness = 0.3 * unit(mix(seed));
        map.envelope = 200.0;
        double angle = 6.0 * unit(mix(seed + 1));
        const double begin = angle;
        std::vector<Point2> rim;
        while (angle < begin + 2.0 * kPi - 0.3) {
            rim.push_back(
                {300.0 + 280.0 * std::cos(angle), 300.0 + 280.0 * std::sin(angle)});
            angle += 0.05 + 1.5 * unit(hash_of({seed, rim.size()}));
        }
        for (std::size_t i = 0; i < rim.size(); ++i)
            map.regions.push_back(
                {"r", "a", {{{300.0, 300.0}, rim[i], rim[(i + 1) % rim.size()]}}});
        const auto drawn = drawn_outlines(map, library, extent, seed);
        for (std::size_t r = 0; r < drawn.size(); ++r) {
            auto closed = drawn[r].outlines[0];
            closed.push_back(closed.front());
            EXPECT_FALSE(crosses_itself(closed)) << seed << ' ' << r;
            for (std::size_t q = 0; q < r; ++q)
                EXPECT_FALSE(cross(drawn[r].outlines[0], drawn[q].outlines[0]))
                    << seed << ' ' << r << ' ' << q;
        }
    }
}

// Strips of very different widths, whose boundaries have no corner in common.
TEST(Outlines, KeepClearOfEachOther) {
    LibraryOptions library;
    library.types = {{.name = "a", .examples = {}}, {.name = "b", .examples = {}}};
    const Extent extent{60, 60, 10.0};
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        MapOptions map;
        map.window = {0.0, 0.0, 600.0, 600.0};
        map.smoothness = 0.1;
        map.envelope = 200.0;
        double at = 0.0;
        for (std::uint64_t i = 0; at < 600.0; ++i) {
            const double next = std::min(
                600.0, at + 5.0 + 150.0 * std::pow(unit(hash_of({seed, i})), 4.0));
            map.regions.push_back(
                {"r", i % 2 ? "a" : "b", {{{at, 0}, {next, 0}, {next, 600}, {at, 600}}}});
            at = next;
        }
        const auto drawn = drawn_outlines(map, library, extent, seed);
        for (std::size_t r = 0; r < drawn.size(); ++r) {
            EXPECT_FALSE(crosses_itself(drawn[r].outlines[0])) << seed << ' ' << r;
            for (std::size_t q = 0; q < r; ++q)
                EXPECT_FALSE(cross(drawn[r].outlines[0], drawn[q].outlines[0]))
                    << seed << ' ' << r << ' ' << q;
        }
    }
}

// Neighbours have the same points along what they share, and the frame stays straight.
TEST(Outlines, NeighboursShareBoundaries) {
    LibraryOptions library;
    library.types = {{.name = "a", .examples = {}}, {.name = "b", .examples = {}}};
    const Extent extent{60, 60, 10.0};
    MapOptions map;
    // The corner at 250 north lies on the western region's side: a T.
    map.regions = {{"west", "a", {{{0, 0}, {280, 0}, {320, 600}, {0, 600}}}},
                   {"south", "b", {{{280, 0}, {600, 0}, {600, 300}, {300, 300}}}},
                   {"north", "a", {{{300, 300}, {600, 300}, {600, 600}, {320, 600}}}}};
    map.window = {0, 0, 600, 600};
    const auto drawn = drawn_outlines(map, library, extent, 4);
    const auto &west = drawn[0].outlines[0], &south = drawn[1].outlines[0];
    EXPECT_NE(std::ranges::find(west, Point2{300.0, 300.0}), west.end());
    int shared = 0;
    for (const Point2& p : south) shared += std::ranges::count(west, p) > 0;
    EXPECT_GT(shared, 30);
    for (const auto& region : drawn)
        for (const Point2& p : region.outlines[0])
            for (const double v : p) EXPECT_TRUE(v >= 0.0 && v <= 600.0) << v;
    // Straight where it is the frame: corners and nothing between.
    EXPECT_EQ(std::ranges::count(west, 0.0, [](const Point2& p) { return p[0]; }), 2);
}

// A seam's smoothness goes before the map's.
TEST(Outlines, SeamsTellOfSmoothness) {
    LibraryOptions library;
    library.types = {{.name = "a", .examples = {}}, {.name = "b", .examples = {}}};
    const Extent extent{60, 60, 10.0};
    MapOptions map;
    map.regions = {{"west", "a", {{{0, 0}, {280, 0}, {320, 600}, {0, 600}}}},
                   {"east", "b", {{{280, 0}, {600, 0}, {600, 600}, {320, 600}}}}};
    map.window = {0, 0, 600, 600};
    map.smoothness = 0.1;
    double rough = 0.0, smooth = 0.0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        library.seams = {};
        rough += bend(drawn_outlines(map, library, extent, seed)[0].outlines[0]);
        library.seams = {{"b", "a", 0.95}};
        smooth += bend(drawn_outlines(map, library, extent, seed)[0].outlines[0]);
    }
    EXPECT_LT(smooth, 0.6 * rough);
}

}  // namespace
}  // namespace cydonia::genetic
