// Maps of terrain types on a terrain's samples (Saunders 2006, IV.3.3.2, V.3.3.6, VII.3).
#include "synth/genetic/map/map.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "field/random.h"
#include "synth/genetic/map/outlines.h"
#include "tests/field/temporary_folder.h"

namespace cydonia::genetic {
namespace {

// What a raster tells its user.
class Told final : public Progress {
  public:
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view sentence) override { notes.emplace_back(sentence); }
    void warn(std::string_view sentence) override { warnings.emplace_back(sentence); }
    static bool says(const std::vector<std::string>& all, std::string_view words) {
        return std::ranges::any_of(
            all, [&](const auto& s) { return s.find(words) != s.npos; });
    }
    std::vector<std::string> notes, warnings;
};

LibraryOptions library_of(std::vector<std::string> names) {
    LibraryOptions library;
    for (std::string& name : names)
        library.types.push_back({.name = std::move(name), .examples = {}});
    return library;
}
const LibraryOptions kLibrary = library_of({"plain", "hills", "mountains"});
constexpr Extent kLand{64, 48, 10.0};

Outline box(double west, double south, double east, double north) {
    return {{west, south}, {east, south}, {east, north}, {west, north}};
}
MapRegion region(std::string name, std::string type, Outline outline) {
    return {std::move(name), std::move(type), {std::move(outline)}};
}
// In metres of kLand, as drawn.
MapOptions map_of(std::vector<MapRegion> regions) {
    MapOptions map;
    map.regions = std::move(regions);
    map.window = {0.0, 0.0, kLand.width(), kLand.depth()};
    map.refine = false;
    return map;
}
MapRegion all_of(std::string type) {
    return region("all of it", std::move(type),
                  box(0.0, 0.0, kLand.width(), kLand.depth()));
}
// West of 300 m plain, east of it hills.
MapOptions halves() {
    return map_of({region("west", "plain", box(0.0, 0.0, 300.0, 480.0)),
                   region("east", "hills", box(300.0, 0.0, 640.0, 480.0))});
}
MapRaster raster_of(const MapOptions& map, std::uint64_t seed = 1) {
    SilentProgress silent;
    return rasterised(map, kLibrary, kLand, seed, silent);
}
std::size_t cells_of(const MapRaster& raster, int type) {
    return std::size_t(std::ranges::count(raster.types, std::uint8_t(type)));
}

TEST(MapRaster, SquareIsExact) {
    // Its sides pass between middles of cells: columns 10 to 19, rows 18 to 32.
    const MapRaster raster = raster_of(map_of(
        {all_of("plain"), region("square", "hills", box(100.0, 150.0, 200.0, 300.0))}));
    for (int y = 0; y < kLand.rows; ++y)
        for (int x = 0; x < kLand.columns; ++x)
            ASSERT_EQ(raster.types(x, y), x >= 10 && x < 20 && y >= 18 && y < 33)
                << x << ' ' << y;
    ASSERT_EQ(raster.all.size(), 2u);
    const auto& square = raster.all[1];
    EXPECT_EQ(square.name, "square");
    EXPECT_EQ(square.type, 1);
    EXPECT_EQ(square.cells, 150u);
    EXPECT_EQ(square.box, (std::array{10, 18, 19, 32}));
    EXPECT_EQ(raster.regions(square.inside[0], square.inside[1]), 1);
    EXPECT_EQ(std::ranges::count(raster.regions, 1), 150);
}

TEST(MapRaster, DistancesOfAStraightBoundary) {
    const MapRaster raster = raster_of(halves());
    for (int y = 0; y < kLand.rows; ++y)
        for (int x = 0; x < kLand.columns; ++x)
            ASSERT_FLOAT_EQ(raster.distances(x, y),
                            float(std::abs(10.0 * (x + 0.5) - 300.0)));
}

// A disc's are its radius less the distance from its middle, to half a cell's diagonal.
TEST(MapRaster, DistancesOfADisc) {
    Outline disc;
    for (int i = 0; i < 360; ++i)
        disc.push_back({320.0 + 150.0 * std::cos(i * M_PI / 180.0),
                        240.0 + 150.0 * std::sin(i * M_PI / 180.0)});
    const MapRaster raster =
        raster_of(map_of({all_of("plain"), region("disc", "hills", disc)}));
    for (int y = 0; y < kLand.rows; ++y)
        for (int x = 0; x < kLand.columns; ++x) {
            const double middle =
                std::hypot(10.0 * (x + 0.5) - 320.0, 480.0 - 10.0 * (y + 0.5) - 240.0);
            EXPECT_NEAR(raster.distances(x, y), std::abs(middle - 150.0), 7.1);
        }
}

TEST(MapRaster, OneTypeHasNoBoundary) {
    const MapRaster raster = raster_of(map_of({all_of("hills")}));
    EXPECT_EQ(raster.all.size(), 1u);
    for (const float distance : raster.distances) {
        EXPECT_TRUE(std::isfinite(distance));
        EXPECT_GT(distance, 640.0f);
    }
}

TEST(MapRaster, HolesAreNotInside) {
    MapRegion ring = region("ring", "hills", box(100.0, 100.0, 400.0, 400.0));
    ring.outlines.push_back(box(200.0, 200.0, 300.0, 300.0));
    const MapRaster raster = raster_of(map_of({all_of("plain"), ring}));
    EXPECT_EQ(cells_of(raster, 1), 900u - 100u);
    EXPECT_EQ(raster.all.size(), 3u);  // what is in the hole is no longer around it
}

// The window is stretched over the land, whatever lies beyond.
TEST(MapRaster, WindowIsStretched) {
    MapOptions map = halves();
    map.window = {200.0, 0.0, 400.0, 480.0};
    const MapRaster raster = raster_of(map);
    EXPECT_EQ(cells_of(raster, 0), 32u * 48u);
    EXPECT_EQ(raster.types(31, 0), 0);
    EXPECT_EQ(raster.types(32, 0), 1);
}

TEST(MapRaster, NeighboursOfOneTypeMerge) {
    Told told;
    const MapRaster raster =
        rasterised(map_of({region("a", "plain", box(0.0, 0.0, 300.0, 480.0)),
                           region("b", "plain", box(300.0, 0.0, 640.0, 480.0))}),
                   kLibrary, kLand, 1, told);
    ASSERT_EQ(raster.all.size(), 1u);
    EXPECT_EQ(raster.all[0].name, "b");  // most of it
    EXPECT_TRUE(Told::says(told.notes, "2 into 'b'"));
    EXPECT_TRUE(told.warnings.empty());
}

TEST(MapRaster, RegionsWithoutACellVanish) {
    Told told;
    const MapRaster raster =
        rasterised(map_of({all_of("plain"),
                           region("speck", "hills", box(301.0, 301.0, 304.0, 304.0)),
                           region("beyond", "hills", box(900.0, 900.0, 990.0, 990.0))}),
                   kLibrary, kLand, 1, told);
    EXPECT_EQ(raster.all.size(), 1u);
    EXPECT_TRUE(Told::says(told.notes, "'speck'")) << told.notes.at(0);
    EXPECT_TRUE(Told::says(told.notes, "'beyond'"));
}

// A horseshoe that the window cuts into two legs.
TEST(MapRaster, ConcaveRegionsFallApart) {
    Told told;
    const Outline horseshoe = {{100.0, 100.0}, {200.0, 100.0}, {200.0, 600.0},
                               {400.0, 600.0}, {400.0, 100.0}, {500.0, 100.0},
                               {500.0, 700.0}, {100.0, 700.0}};
    const MapRaster raster =
        rasterised(map_of({all_of("plain"), region("horseshoe", "hills", horseshoe)}),
                   kLibrary, kLand, 1, told);
    EXPECT_EQ(raster.all.size(), 3u);
    EXPECT_TRUE(Told::says(told.notes, "'horseshoe'"));
    std::set<std::string> names;
    for (const auto& found : raster.all) names.insert(found.name);
    EXPECT_EQ(names, (std::set<std::string>{"all of it", "horseshoe", "horseshoe 2"}));
}

TEST(MapRaster, GapsGoToTheNearest) {
    Told told;
    const MapRaster raster =
        rasterised(map_of({region("west", "plain", box(0.0, 0.0, 200.0, 480.0)),
                           region("east", "hills", box(440.0, 0.0, 640.0, 480.0))}),
                   kLibrary, kLand, 1, told);
    EXPECT_TRUE(Told::says(told.warnings, "38 % of the land is in no region"))
        << told.warnings.at(0);
    for (int x = 0; x < kLand.columns; ++x) EXPECT_EQ(raster.types(x, 20), x >= 32) << x;
}

TEST(MapRaster, LaterRegionsLieOnTop) {
    Told told;
    const MapRaster raster =
        rasterised(map_of({region("first", "plain", box(0.0, 0.0, 400.0, 480.0)),
                           region("second", "hills", box(300.0, 0.0, 640.0, 480.0))}),
                   kLibrary, kLand, 1, told);
    EXPECT_EQ(cells_of(raster, 0), 30u * 48u);
    EXPECT_TRUE(Told::says(told.warnings, "'second' lies over 'first' on 16 %"))
        << told.warnings.at(0);
}

TEST(MapRaster, NarrowRegionsAreNamed) {
    Told told;
    rasterised(
        map_of({all_of("plain"), region("lane", "hills", box(0.0, 0.0, 640.0, 30.0))}),
        kLibrary, kLand, 1, told);
    EXPECT_TRUE(Told::says(told.warnings, "'lane' is nowhere wider"));
    EXPECT_FALSE(Told::says(told.warnings, "'all of it'"));
}

// Section VII.6.
TEST(MapRaster, TransitionsLieBetween) {
    LibraryOptions library = kLibrary;
    library.transitions.push_back({"hills", "plain", "mountains", 60.0});
    SilentProgress silent;
    const MapRaster raster = rasterised(halves(), library, kLand, 1, silent);
    for (int x = 0; x < kLand.columns; ++x)
        EXPECT_EQ(raster.types(x, 7), x < 27 ? 0 : x < 33 ? 2 : 1) << x;
    // Not between others.
    library.transitions[0] = {"mountains", "plain", "hills", 60.0};
    EXPECT_EQ(rasterised(halves(), library, kLand, 1, silent).types,
              raster_of(halves()).types);
}

// Three regions that share corners, one of them in the middle of another's side.
MapOptions thirds() {
    MapOptions map =
        map_of({region("north", "mountains", box(0.0, 250.0, 640.0, 480.0)),
                region("west", "plain",
                       {{0.0, 0.0}, {350.0, 0.0}, {280.0, 250.0}, {0.0, 250.0}}),
                region("east", "hills",
                       {{350.0, 0.0}, {640.0, 0.0}, {640.0, 250.0}, {280.0, 250.0}})});
    map.refine = true;
    return map;
}

TEST(MapRaster, RefinedNeighboursLeaveNoGap) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        Told told;
        const MapRaster raster = rasterised(thirds(), kLibrary, kLand, seed, told);
        EXPECT_TRUE(told.warnings.empty()) << told.warnings[0];  // no gap, no overlap
        EXPECT_EQ(raster.all.size(), 3u);
    }
}

TEST(MapRaster, SeedsDiffer) {
    EXPECT_NE(raster_of(thirds(), 1).types, raster_of(thirds(), 2).types);
    EXPECT_EQ(raster_of(thirds(), 1).types, raster_of(thirds(), 1).types);
}

TEST(MapRaster, SameWithAnyNumberOfThreads) {
    const auto made = [](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                        threads);
        return raster_of(thirds(), 5);
    };
    const MapRaster one = made(1), four = made(4);
    EXPECT_EQ(one.types, four.types);
    EXPECT_EQ(one.regions, four.regions);
    EXPECT_EQ(one.distances, four.distances);
}

// The map at twice the samples is the same map.
TEST(MapRaster, SameAtOtherSamples) {
    const Extent fine{128, 96, 5.0};
    SilentProgress silent;
    const MapRaster coarse = raster_of(thirds(), 3),
                    twice = rasterised(thirds(), kLibrary, fine, 3, silent);
    int unlike = 0;
    for (int y = 0; y < kLand.rows; ++y)
        for (int x = 0; x < kLand.columns; ++x)
            unlike += coarse.types(x, y) != twice.types(2 * x, 2 * y);
    EXPECT_LT(unlike, kLand.columns * kLand.rows / 20);
}

// What is far beyond the window costs nothing and changes nothing.
TEST(MapRaster, FarCornersAreFine) {
    for (const double far : {1e4, 1e6, 1e9}) {
        MapOptions map = map_of({region("a", "plain", box(-far, -far, 300.0, far)),
                                 region("b", "hills", box(300.0, -far, far, far))});
        EXPECT_EQ(raster_of(map).types, raster_of(halves()).types) << far;
        // Refined it is hardly longer in work.
        map.refine = true;
        raster_of(map);
        map = map_of({region("a", "plain", box(-far, -far, 640.0, far)),
                      region("b", "hills", box(far, -far, 2.0 * far, far))});
        EXPECT_EQ(cells_of(raster_of(map), 1), 0u) << far;
    }
}

TEST(MapRaster, TinyWindows) {
    MapOptions map = halves();
    map.refine = true;
    for (const double size : {1.0, 1e-6, 1e-300}) {
        map.window = {10.0, 10.0, 10.0 + size, 10.0 + size};
        if (map.window[2] == 10.0) continue;
        EXPECT_EQ(cells_of(raster_of(map), 0), kLand.columns * std::size_t(kLand.rows));
    }
}

void expect_refused(const MapOptions& map, std::string_view words) {
    SilentProgress silent;
    expect_error(ExitCode::kBadRequest, words,
                 [&] { rasterised(map, kLibrary, kLand, 1, silent); });
}

TEST(BadMap, SaysWhatToChange) {
    expect_refused(map_of({}), "draw at least one");
    expect_refused(map_of({region("a", "hils", box(0, 0, 100, 100))}),
                   "region 'a': the library has no type 'hils'");
    expect_refused(map_of({region("line", "hills", {{0, 0}, {100, 100}})}),
                   "region 'line' has an outline of 2 corners");
    expect_refused(map_of({region("flat", "hills", {{0, 0}, {100, 0}, {200, 0}})}),
                   "region 'flat' has an outline that encloses nothing");
    expect_refused(map_of({region("slope", "hills", {{0, 0}, {100, 33}, {300, 99}})}),
                   "region 'slope' has an outline that encloses nothing");
    expect_refused(
        map_of({region("tie", "hills", {{0, 0}, {200, 200}, {200, 0}, {0, 200}})}),
        "region 'tie' crosses itself near 100 m east, 100 m north");
    expect_refused(map_of({region("away", "hills", box(900, 900, 990, 990))}),
                   "no region of the map lies in its window");
    expect_refused(map_of({{"empty", "hills", {}}}), "region 'empty' has no outline");
}

// Every corner of outlines is a whole number of bends; nothing of this may end otherwise
// than in land or in a message.
TEST(BadMap, RandomOutlinesEndInLandOrAMessage) {
    SilentProgress silent;
    int drawn = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        MapOptions map = map_of({});
        map.refine = seed % 2 == 0;
        for (std::uint64_t r = 0; r < 3; ++r) {
            Outline outline;
            const std::uint64_t corners = 1 + hash_of({seed, r}) % 5;
            for (std::uint64_t i = 0; i < corners; ++i)
                outline.push_back({100.0 * double(hash_of({seed, r, i, 1}) % 9) - 100.0,
                                   100.0 * double(hash_of({seed, r, i, 2}) % 9) - 100.0});
            map.regions.push_back(region("r", "hills", outline));
        }
        drawn += survives([&] { rasterised(map, kLibrary, kLand, seed, silent); });
    }
    EXPECT_GT(drawn, 10);
}

// Section VII.3.
struct AutomaticMaps : testing::Test {
    LibraryOptions library = library_of({"high", "low", "mid", "unused"});
    std::vector<double> means = {2000.0, 10.0, 600.0,
                                 std::numeric_limits<double>::quiet_NaN()};
    MapRaster raster(std::uint64_t seed, int regions = 24) const {
        SilentProgress silent;
        return rasterised(automatic_map(library, means, regions, kWide, seed), library,
                          kWide, seed, silent);
    }
    static constexpr Extent kWide{160, 120, 30.0};
};

TEST_F(AutomaticMaps, CoversTheLandExactly) {
    for (const int regions : {1, 2, 24, 200})
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            Told told;
            rasterised(automatic_map(library, means, regions, kWide, seed), library,
                       kWide, seed, told);
            EXPECT_FALSE(Told::says(told.warnings, "no region")) << regions;
            EXPECT_FALSE(Told::says(told.warnings, "lies over")) << regions;
        }
}

TEST_F(AutomaticMaps, TypesAreAboutAsLargeAndLieByHeight) {
    double next = 0.0, apart = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const MapRaster made = raster(seed);
        for (const int type : {0, 1, 2}) {
            const double share = double(cells_of(made, type)) / (160.0 * 120.0);
            EXPECT_GT(share, 0.2) << seed;
            EXPECT_LT(share, 0.47) << seed;
        }
        EXPECT_EQ(cells_of(made, 3), 0u);
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x + 1 < 160; ++x) {
                const int a = made.types(x, y), b = made.types(x + 1, y);
                if (a == b) continue;
                (a == 2 || b == 2 ? next : apart) += 1.0;  // high beside low is apart
            }
    }
    EXPECT_GT(next, 6.0 * apart);  // by chance 2
}

}  // namespace
}  // namespace cydonia::genetic
