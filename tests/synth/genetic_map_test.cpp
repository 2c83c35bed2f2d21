#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "field/error.h"
#include "synth/genetic/map/boundary.h"
#include "synth/genetic/map/map.h"
#include "synth/genetic/map/outlines.h"

namespace cydonia::genetic {
namespace {

LibraryOptions library_of(std::initializer_list<const char*> names) {
    LibraryOptions library;
    for (const char* name : names) library.types.push_back({name, {}, {}});
    return library;
}

MapRegion region(const char* type, Outline outline) {
    return {type, type, {std::move(outline)}};
}

const Extent kSquare{100, 100, 10.0};  // 1 km

// A west and an east half, and what is said of them.
class Map : public testing::Test {
  protected:
    class Heard final : public Progress {
      public:
        void step(std::string_view) override {}
        void report(double) override {}
        void note(std::string_view s) override { text += std::string(s) + "\n"; }
        void warn(std::string_view s) override { text += "! " + std::string(s) + "\n"; }
        std::string text;
    };

    MapRaster raster(std::uint64_t seed = 1) {
        return rasterised(map_, library_, kSquare, seed, heard_);
    }
    std::string refused() {
        try {
            raster();
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

    LibraryOptions library_ = library_of({"plain", "hills", "foot"});
    MapOptions map_{.regions = {region("plain", {{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}}),
                                region("hills", {{0.5, 0}, {1, 0}, {1, 1}, {0.5, 1}})}};
    Heard heard_;
};

TEST_F(Map, IsExactWhereBoundariesAreNotRefined) {
    map_.refine = false;
    const MapRaster m = raster();
    ASSERT_EQ(m.all.size(), 2u);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            EXPECT_EQ(m.types(x, y), x >= 50);
            // From the cell's middle to the boundary at 500 m.
            EXPECT_FLOAT_EQ(m.distances(x, y), float(std::abs((x + 0.5) * 10.0 - 500.0)));
        }
    EXPECT_EQ(m.all[0].cells, 5000u);
    EXPECT_EQ(m.all[1].box, (std::array{50, 0, 99, 99}));
    EXPECT_EQ(heard_.text, "");
}

TEST_F(Map, RefinedNeighboursShareTheirBoundary) {
    map_.smoothness = 0.2;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const MapRaster m = raster(seed);
        EXPECT_EQ(heard_.text, "");  // no gap, no overlap
        EXPECT_EQ(m.all.size(), 2u);
        int off = 0;
        for (int y = 0; y < 100; ++y) {
            int west = 0;
            for (int x = 0; x < 100; ++x) west += m.types(x, y) == 0;
            off = std::max(off, std::abs(west - 50));
        }
        EXPECT_GT(off, 2);
        EXPECT_LE(off, 21);  // a fifth of its length
    }
}

TEST_F(Map, KeepsToAnEnvelope) {
    map_.envelope = 30.0;
    const auto drawn = drawn_outlines(map_, library_, kSquare, 3);
    double most = 0.0;
    for (const Point2& p : drawn[0].outlines[0])
        if (p[0] > 250.0) most = std::max(most, std::abs(p[0] - 500.0));
    EXPECT_LE(most, 30.0 + 1e-9);
    EXPECT_GT(most, 5.0);
}

TEST_F(Map, IsTheSameForAnyNumberOfThreads) {
    const auto with = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        threads);
        return raster(7).types;
    };
    EXPECT_EQ(with(1), with(4));
}

TEST_F(Map, FillsGapsFromTheNearestRegion) {
    map_.refine = false;
    map_.regions[1].outlines[0] = {{0.8, 0}, {1, 0}, {1, 1}, {0.8, 1}};
    const MapRaster m = raster();
    EXPECT_NE(heard_.text.find("! map: 30 % of the land is in no region"),
              std::string::npos)
        << heard_.text;
    EXPECT_EQ(m.types(64, 50), 0);
    EXPECT_EQ(m.types(65, 50), 1);
}

TEST_F(Map, LaterRegionsLieOnTop) {
    map_.refine = false;
    map_.regions[1].outlines[0] = {{0.4, 0}, {1, 0}, {1, 1}, {0.4, 1}};
    const MapRaster m = raster();
    EXPECT_EQ(m.types(40, 5), 1);
    EXPECT_NE(heard_.text.find("! map: 'hills' lies over 'plain' on 10 % of the land"),
              std::string::npos)
        << heard_.text;
    // But one within another is meant.
    heard_.text.clear();
    map_.regions = {region("plain", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
                    region("hills", {{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}})};
    EXPECT_EQ(raster().types(50, 50), 1);
    EXPECT_EQ(heard_.text, "");
}

TEST_F(Map, NeighboursOfOneTypeAreOneRegion) {
    map_.refine = false;
    map_.regions[1].type = "plain", map_.regions[1].name = "east";
    const MapRaster m = raster();
    EXPECT_EQ(m.all.size(), 1u);
    EXPECT_NE(heard_.text.find("neighbours of one type are one region: 2 into 'plain'"),
              std::string::npos)
        << heard_.text;
}

TEST_F(Map, AWindowCutsRegionsApart) {
    map_.refine = false;
    // A U of hills, of which the window shows the arms.
    map_.regions = {region("plain", {{0, 0}, {1, 0}, {1, 2}, {0, 2}}),
                    region("hills", {{0.1, 0.2},
                                     {0.9, 0.2},
                                     {0.9, 1.8},
                                     {0.7, 1.8},
                                     {0.7, 0.5},
                                     {0.3, 0.5},
                                     {0.3, 1.8},
                                     {0.1, 1.8}})};
    map_.window = {0.0, 1.0, 1.0, 2.0};
    const MapRaster m = raster();
    EXPECT_EQ(m.all.size(), 3u);
    EXPECT_NE(heard_.text.find("1 regions fall into several parts"), std::string::npos)
        << heard_.text;
    map_.window = {0.0, 0.0, 1.0, 0.1};
    heard_.text.clear();
    EXPECT_EQ(raster().all.size(), 1u);
    EXPECT_NE(heard_.text.find("1 regions have no cell"), std::string::npos);
}

TEST_F(Map, TransitionsComeBetween) {
    map_.refine = false;
    library_.transitions = {{"plain", "hills", "foot", 200.0}};
    const MapRaster m = raster();
    for (int x = 0; x < 100; ++x)
        EXPECT_EQ(m.types(x, 50), x < 40 ? 0 : x < 60 ? 2 : 1) << x;
    EXPECT_EQ(m.all.size(), 3u);
}

TEST_F(Map, WarnsOfRegionsNarrowerThanAGene) {
    map_.refine = false;
    map_.regions.push_back(
        region("foot", {{0.4, 0.5}, {0.6, 0.5}, {0.6, 0.54}, {0.4, 0.54}}));
    raster();
    EXPECT_NE(heard_.text.find("'foot' is nowhere wider than"), std::string::npos)
        << heard_.text;
}

TEST_F(Map, RefusesWhatIsNoMap) {
    const MapOptions good = map_;
    map_.regions[0].outlines[0] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    EXPECT_NE(refused().find("region 'plain' crosses itself"), std::string::npos);
    map_ = good;
    map_.regions[0].outlines[0] = {{0, 0}, {1, 1}};
    EXPECT_NE(refused().find("an outline of 2 corners"), std::string::npos);
    map_ = good;
    map_.regions[0].outlines[0] = {{0, 0}, {0.5, 0.5}, {1, 1}};
    EXPECT_NE(refused(), "");
    map_ = good;
    map_.regions[1].type = "hils";
    EXPECT_EQ(refused(), "region 'hills': the library has no type 'hils'");
    map_ = good;
    map_.window = {5.0, 5.0, 6.0, 6.0};
    EXPECT_NE(refused().find("no region of the map lies in its window"),
              std::string::npos);
    map_.regions.clear();
    EXPECT_EQ(refused(), "the map has no regions; draw at least one");
}

TEST(Boundary, KeepsItsEndsAndDoesNotCrossItself) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        StraightBoundary b{.from = {10.0, 20.0},
                           .to = {900.0, 400.0},
                           .smoothness = double(seed % 10) / 10.0,
                           .envelope = 120.0,
                           .free_at = {std::numbers::pi, 1.0},
                           .segment = 10.0};
        const auto line = refined(b, seed);
        EXPECT_EQ(line.front(), b.from);
        EXPECT_EQ(line.back(), b.to);
        EXPECT_FALSE(crosses_itself(line)) << seed;
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            EXPECT_LT(
                std::hypot(line[i + 1][0] - line[i][0], line[i + 1][1] - line[i][1]),
                10.01);
    }
}

// Mean turn from segment to segment, radians.
double bend_of(double smoothness) {
    double sum = 0.0;
    int count = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto line = refined({.from = {0, 0},
                                   .to = {1000, 0},
                                   .smoothness = smoothness,
                                   .envelope = 200.0,
                                   .free_at = {std::numbers::pi, std::numbers::pi},
                                   .segment = 10.0},
                                  seed);
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            const double a = std::atan2(line[i][1] - line[i - 1][1],
                                        line[i][0] - line[i - 1][0]),
                         b = std::atan2(line[i + 1][1] - line[i][1],
                                        line[i + 1][0] - line[i][0]);
            sum += std::abs(std::remainder(b - a, 2.0 * std::numbers::pi)), ++count;
        }
    }
    return sum / count;
}

TEST(Boundary, BendsAsSmoothnessAsks) { EXPECT_GT(bend_of(0.1), 2.0 * bend_of(0.9)); }

TEST(Boundary, MeetsTheNextWithoutACorner) {
    // Two edges at a right angle: the middle of the bend is each's last course.
    double off = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const double asked = 0.3;
        const auto line = refined({.from = {0, 0},
                                   .to = {120, 0},
                                   .smoothness = 0.9,
                                   .envelope = 30.0,
                                   .free_at = {std::numbers::pi, std::numbers::pi},
                                   .course = {asked, 0.0},
                                   .segment = 10.0},
                                  seed);
        off += std::abs(std::atan2(line[1][1], line[1][0]) - asked) / 20.0;
    }
    EXPECT_LT(off, 0.15);
}

TEST(AutomaticMap, PutsLikeBesideLike) {
    const LibraryOptions library = library_of({"peaks", "sea", "plain", "hills"});
    const std::vector<double> means = {900.0, -20.0, 30.0, 250.0};
    const Extent extent{200, 150, 50.0};
    const MapOptions map = automatic_map(library, means, 40, extent, 5);
    EXPECT_EQ(map.regions.size(), 40u);
    SilentProgress silent;
    const MapRaster m = rasterised(map, library, extent, 5, silent);
    std::array<std::size_t, 4> cells{};
    for (const std::uint8_t t : m.types) ++cells[t];
    for (const std::size_t n : cells) EXPECT_GT(n, m.types.size() / 8);
    // Steps between neighbours against those of types put anywhere.
    const std::array<int, 4> rank = {3, 0, 1, 2};
    int steps = 0, borders = 0;
    for (int y = 0; y < 150; ++y)
        for (int x = 0; x + 1 < 200; ++x) {
            const int d = std::abs(rank[m.types(x, y)] - rank[m.types(x + 1, y)]);
            steps += d, borders += d > 0;
        }
    EXPECT_LT(double(steps) / borders, 1.35);  // of any two different ones 1.67
    EXPECT_EQ(automatic_map(library, means, 40, extent, 5).regions[7].outlines,
              map.regions[7].outlines);
    EXPECT_THROW(
        automatic_map(library, std::vector<double>(4, std::nan("")), 4, extent, 1),
        Error);
}

}  // namespace
}  // namespace cydonia::genetic
