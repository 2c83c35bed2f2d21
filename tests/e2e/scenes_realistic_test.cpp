// The realistic landscapes of Rusnell 2009, section 4.2: each test measures what the
// thesis calls characteristic of one, and that it goes when its cause is taken away.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "field/dem.h"
#include "tests/app/program.h"
#include "tests/e2e/land_measures.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

using Changes = std::vector<std::string>;

fs::path scene_file(const std::string& scene, const std::string& file) {
    return fs::path(CYDONIA_SOURCE_DIR) / "scenes" / scene / file;
}

// KEY=VALUE of the scene's one stage, as after --set.
std::string stage(const std::string& change) { return "terrain.stage[0]." + change; }

struct RealisticScenes : testing::Test {
    TemporaryFolder folder;
    int lands = 0;

    // The scene's land at half its samples.
    Terrain land(const std::string& scene, const Changes& changes = {}) {
        const fs::path out = folder / (scene + std::to_string(lands++));
        std::vector<std::string> arguments{
            "synth", scene_file(scene, "scene.toml").string(),
            "-o",    out.string(),
            "--set", "terrain.samples=256"};
        for (const std::string& change : changes) {
            arguments.push_back("--set");
            arguments.push_back(change);
        }
        const Outcome outcome = run({folder.path()}, arguments);
        if (outcome.code != 0) throw std::runtime_error(outcome.err);
        return read_dem(open_source(out / "terrain.exr"));
    }
};

Field<std::uint8_t> cells_of(const std::string& scene, const std::string& picture,
                             const Terrain& terrain) {
    return drawn(open_source(scene_file(scene, picture)), terrain.heights);
}

// Metres from what a picture of the scene draws.
Field<float> distances(const std::string& scene, const std::string& picture,
                       const Terrain& terrain) {
    return distances_to(cells_of(scene, picture, terrain), terrain.spacing);
}

// Metres into what it draws, from its edge.
Field<float> depths(const std::string& scene, const std::string& picture,
                    const Terrain& terrain) {
    Field<std::uint8_t> cells = cells_of(scene, picture, terrain);
    for (std::uint8_t& cell : cells) cell = cell == 0;
    return distances_to(cells, terrain.spacing);
}

// Metres from a place given in metres from the north-west corner.
Field<float> distances_from(double east, double south, const Terrain& terrain) {
    Field<float> far(terrain.heights.width(), terrain.heights.height());
    for (int y = 0; y < far.height(); ++y)
        for (int x = 0; x < far.width(); ++x)
            far(x, y) = static_cast<float>(std::hypot(
                (x + 0.5) * terrain.spacing - east, (y + 0.5) * terrain.spacing - south));
    return far;
}

double mean_between(const Field<float>& values, const Field<float>& distances,
                    double least, double most) {
    return mean_of(values_between(values, distances, least, most));
}

std::vector<float> all_of(const Field<float>& values) {
    return {values.begin(), values.end()};
}

// How much of the bend of a valley that runs south, between its walls 300 m from the
// lowest line, is within 60 m of that line: 1 is a crease, 1/5 a parabola.
double crease(const Terrain& terrain) {
    const Field<float>& h = terrain.heights;
    const int west = h.width() * 3 / 10, east = h.width() * 7 / 10;
    const auto bend = [&](int x, int y, double metres) {
        const int step = static_cast<int>(metres / terrain.spacing);
        return (h(x - step, y) + h(x + step, y) - 2.0 * h(x, y)) / step;
    };
    double near = 0.0, far = 0.0;
    for (int y = 0; y < h.height(); ++y) {
        const auto row = h.row(y);
        const auto foot = std::min_element(row.begin() + west, row.begin() + east);
        const int x = static_cast<int>(foot - row.begin());
        near += bend(x, y, 60.0);
        far += bend(x, y, 300.0);
    }
    return near / far;
}

}  // namespace

// What measures the scenes, on a land that is known.
TEST(LandMeasures, APeakIsAsProminentAsItsSaddleIsDeep) {
    Field<float> heights(5, 1);
    std::ranges::copy(std::array{1.0f, 9.0f, 4.0f, 6.0f, 2.0f}, heights.begin());
    const std::vector<Peak> peaks = peaks_of(heights, 2.0f);
    ASSERT_EQ(peaks.size(), 2u);
    EXPECT_EQ(peaks[0].x, 1);
    EXPECT_EQ(peaks[0].prominence, 8.0f);
    EXPECT_EQ(peaks[1].x, 3);
    EXPECT_EQ(peaks[1].prominence, 2.0f);
    EXPECT_EQ(peaks[1].parent_x, 1);
    EXPECT_EQ(peaks_of(heights, 3.0f).size(), 1u);
}

TEST_F(RealisticScenes, VValleyEndsInACrease) {
    EXPECT_GT(crease(land("v-valley")), 0.7);
    const Terrain without = land(
        "v-valley",
        {stage("blending_bias=3"), stage("profile[0].image=../u-valley/profile.svg")});
    EXPECT_LT(crease(without), 0.55);
}

TEST_F(RealisticScenes, UValleyHasARoundFloor) {
    EXPECT_LT(crease(land("u-valley")), 0.55);
    const Terrain without = land(
        "u-valley",
        {stage("blending_bias=15"), stage("profile[0].image=../v-valley/profile.svg")});
    EXPECT_GT(crease(without), 0.7);
}

TEST_F(RealisticScenes, CanyonHasSteepWallsAndFlatTops) {
    const auto wall = [](const Terrain& terrain) {
        const Field<float> far = distances("canyon", "plateaus.svg", terrain);
        return quantile_of(values_between(slopes_of(terrain), far, 0.0, 200.0), 0.5);
    };
    const Terrain canyon = land("canyon");
    const Field<float> slopes = slopes_of(canyon);
    const Field<float> in = depths("canyon", "plateaus.svg", canyon);
    const Field<float> out = distances("canyon", "plateaus.svg", canyon);
    EXPECT_LT(quantile_of(values_between(slopes, in, 100.0, 1e9), 0.9), 10.0) << "tops";
    EXPECT_GT(wall(canyon), 45.0);
    EXPECT_LT(quantile_of(values_between(slopes, out, 200.0, 1e9), 0.5), 15.0) << "basin";
    EXPECT_LT(wall(land("canyon", {stage("group[0].profile=shield")})), 35.0);
}

TEST_F(RealisticScenes, LayersAreSevenLongParallelRidges) {
    // How much steeper the land is across the ridges than along them.
    const auto stretch = [](const Terrain& terrain) {
        const Field<float>& h = terrain.heights;
        double along = 0.0, across = 0.0;
        for (int y = 1; y < h.height(); ++y)
            for (int x = 1; x < h.width(); ++x) {
                along += std::pow(h(x, y) - h(x - 1, y), 2.0);
                across += std::pow(h(x, y) - h(x, y - 1), 2.0);
            }
        return std::sqrt(across / along);
    };
    const Terrain layers = land("layers");
    EXPECT_GT(stretch(layers), 1.35);
    std::vector<float> crests;  // met on the way from south to north
    for (int x = 0; x < layers.heights.width(); ++x) {
        Field<float> column(1, layers.heights.height());
        for (int y = 0; y < column.height(); ++y) column(0, y) = layers.heights(x, y);
        crests.push_back(static_cast<float>(peaks_of(column, 100.0f).size()));
    }
    EXPECT_EQ(quantile_of(crests, 0.5), 7.0);
    const Terrain without =
        land("layers", {stage("group[0].strokes.image=../canyon/plateaus.svg")});
    EXPECT_LT(stretch(without), 1.1);
}

TEST_F(RealisticScenes, KarstTowersAreSteepAndIsolated) {
    // As high above the ground between them as half the highest.
    const auto towers = [](const Terrain& terrain) {
        const float highest = std::ranges::max(terrain.heights);
        return peaks_of(terrain.heights, 0.5f * highest).size();
    };
    const Terrain karst = land("tower-karst");
    EXPECT_EQ(towers(karst), 8u);
    const float highest = std::ranges::max(karst.heights);
    const std::vector<float> walls =
        values_between(slopes_of(karst), karst.heights, 0.2 * highest, 0.7 * highest);
    EXPECT_GT(quantile_of(walls, 0.5), 60.0);
    EXPECT_LT(quantile_of(all_of(karst.heights), 0.5), 0.1 * highest) << "valleys";
    EXPECT_LT(towers(land("tower-karst", {stage("group[0].profile=shield")})), 8u);
}

TEST_F(RealisticScenes, HillsAreSmoothAndRound) {
    // Where the land is kinked most: change of slope over 240 m, east and south.
    const auto kink = [](const Terrain& terrain) {
        const Field<float>& h = terrain.heights;
        std::vector<float> kinks;
        for (int y = 6; y + 6 < h.height(); ++y)
            for (int x = 6; x + 6 < h.width(); ++x)
                kinks.push_back(std::abs(h(x - 6, y) + h(x + 6, y) + h(x, y - 6) +
                                         h(x, y + 6) - 4.0f * h(x, y)) /
                                120.0f);
        return quantile_of(kinks, 0.99);
    };
    const Terrain hills = land("hills");
    EXPECT_LT(quantile_of(all_of(slopes_of(hills)), 0.95), 30.0);
    EXPECT_LT(kink(hills), 0.65);
    EXPECT_GE(peaks_of(hills.heights, 60.0f).size(), 6u);
    EXPECT_GT(kink(land("hills", {stage("group[0].profile=cone")})), 0.75);
}

TEST_F(RealisticScenes, MountainsStandInThreeRegions) {
    // Mean height of the valleys' middle, as a share of that of the mountains.
    const auto valleys = [](const Terrain& terrain) {
        const Field<float> in = depths("mountain-range", "valleys.svg", terrain);
        const Field<float> out = distances("mountain-range", "valleys.svg", terrain);
        return mean_between(terrain.heights, in, 250.0, 1e9) /
               mean_between(terrain.heights, out, 250.0, 1e9);
    };
    const Terrain range = land("mountain-range");
    EXPECT_LT(valleys(range), 0.3);
    const double width = range.width();
    for (const auto& [east, south] : {std::array{0.5, 0.2}, {0.2, 0.7}, {0.8, 0.7}}) {
        const Field<float> far = distances_from(east * width, south * width, range);
        EXPECT_GT(quantile_of(values_between(range.heights, far, 0.0, 700.0), 0.9), 250.0)
            << "no mountains at " << east << ", " << south;
    }
    std::vector<float> heights;
    for (const Peak& peak : peaks_of(range.heights, 60.0f))
        heights.push_back(peak.height);
    EXPECT_GT(heights.size(), 40u);
    EXPECT_GT(deviation_of(heights) / mean_of(heights), 0.12) << "heterogeneous";
    const Terrain without =
        land("mountain-range", {stage("group[0].peaks.keep_out=../hills/crests.svg")});
    EXPECT_GT(valleys(without), 0.5);
}

TEST_F(RealisticScenes, RiverTerracesAreThreeFlatLevelsInOrder) {
    // Metres from the river of all that is within 10 m of a height.
    const auto level = [](const Terrain& terrain, float height) {
        const Field<float> river = distances("river-terrace", "river.svg", terrain);
        return values_between(river, terrain.heights, height - 10.0, height + 10.0);
    };
    // Whether every level lies farther from the river than the ones below it.
    const auto ascending = [&](const Terrain& terrain) {
        double nearer = 0.0;
        for (const float height : {0.0f, 80.0f, 480.0f, 880.0f}) {
            const std::vector<float> terrace = level(terrain, height);
            if (terrace.empty() || quantile_of(terrace, 0.5) <= nearer) return false;
            nearer = quantile_of(terrace, 0.5);
        }
        return true;
    };
    const Terrain terraces = land("river-terrace");
    EXPECT_TRUE(ascending(terraces));
    const auto cells = static_cast<double>(terraces.heights.size());
    double flat = 0.0;
    for (const float height : {0.0f, 80.0f, 480.0f, 880.0f}) {
        const double share = static_cast<double>(level(terraces, height).size()) / cells;
        EXPECT_GT(share, 0.01) << height;
        flat += share;
    }
    EXPECT_GT(flat, 0.75);
    const std::string levels = "group[0].terraces.level";
    EXPECT_FALSE(ascending(land("river-terrace", {stage(levels + "[1].cost=800"),
                                                  stage(levels + "[2].cost=400")})));
}

TEST_F(RealisticScenes, FaultDipsAndIsRougherNearby) {
    // Mean step from a sample to what its neighbours lead one to expect, metres.
    const auto roughness = [](const Terrain& terrain, double least, double most) {
        const Field<float>& h = terrain.heights;
        Field<float> steps(h.width(), h.height());
        for (int y = 1; y + 1 < h.height(); ++y)
            for (int x = 1; x + 1 < h.width(); ++x)
                steps(x, y) = std::abs(h(x, y) - 0.25f * (h(x - 1, y) + h(x + 1, y) +
                                                          h(x, y - 1) + h(x, y + 1)));
        return mean_between(steps, distances("fault", "fault.svg", terrain), least, most);
    };
    const auto dip = [](const Terrain& terrain) {
        const Field<float> far = distances("fault", "fault.svg", terrain);
        double lip = 0.0;
        for (double d = 20.0; d < 160.0; d += 20.0)
            lip = std::max(lip, mean_between(terrain.heights, far, d, d + 20.0));
        return lip - mean_between(terrain.heights, far, -1.0, 10.0);
    };
    const Terrain fault = land("fault");
    EXPECT_GT(dip(fault), 40.0);
    const double near = roughness(fault, 100.0, 700.0),
                 middle = roughness(fault, 700.0, 1200.0),
                 far = roughness(fault, 1200.0, 1e9);
    EXPECT_GT(near, 1.5 * middle);
    EXPECT_GT(middle, far);
    const Terrain without = land(
        "fault", {stage("group[0].ridges.count=0"), stage("group[0].lip.distance=5")});
    EXPECT_LT(dip(without), 20.0);
    EXPECT_LT(roughness(without, 100.0, 700.0), 0.7 * near);
}

TEST_F(RealisticScenes, CraterHasARimAndABowl) {
    // Mean height of the rim above the land around it.
    const auto rise = [](const Terrain& terrain) {
        const Field<float> centre = distances_from(2620.0, 3180.0, terrain);
        const Field<float> rim = distances("crater", "rim.svg", terrain);
        return mean_between(terrain.heights, rim, -1.0, 10.0) -
               mean_between(terrain.heights, centre, 1000.0, 1300.0);
    };
    const Terrain crater = land("crater");
    EXPECT_GT(rise(crater), 60.0);
    const Field<float> slopes = slopes_of(crater);
    const Field<float> centre = distances_from(2620.0, 3180.0, crater);
    const Field<float> rim = distances("crater", "rim.svg", crater);
    EXPECT_GT(mean_between(crater.heights, rim, -1.0, 10.0) -
                  mean_between(crater.heights, centre, -1.0, 250.0),
              150.0);
    EXPECT_LT(quantile_of(values_between(slopes, centre, -1.0, 250.0), 0.9), 10.0)
        << "a smooth basin";
    EXPECT_GT(quantile_of(values_between(slopes, centre, 550.0, 680.0), 0.5), 30.0)
        << "steep walls";
    EXPECT_LT(rise(land("crater", {stage("group[3].cost.less=0")})), 0.0);
}

TEST_F(RealisticScenes, CinderConeHasABasinAndAnEvenFlank) {
    const auto flank = [](const Terrain& terrain) {
        const Field<float> centre = distances_from(2580.0, 2620.0, terrain);
        std::vector<float> slopes;
        for (double r = 500.0; r < 1300.0; r += 200.0)
            slopes.push_back(static_cast<float>(
                (mean_between(terrain.heights, centre, r - 20.0, r + 20.0) -
                 mean_between(terrain.heights, centre, r + 180.0, r + 220.0)) /
                200.0));
        return std::ranges::max(slopes) / std::ranges::min(slopes);
    };
    const Terrain cone = land("cinder-cone");
    const Field<float> centre = distances_from(2580.0, 2620.0, cone);
    EXPECT_GT(mean_between(cone.heights, centre, 360.0, 440.0) -
                  mean_between(cone.heights, centre, -1.0, 100.0),
              50.0);
    EXPECT_LT(flank(cone), 1.35);
    const Field<float> west = distances_from(2180.0, 2620.0, cone),
                       east = distances_from(2980.0, 2620.0, cone);
    EXPECT_GT(mean_between(cone.heights, east, -1.0, 60.0),
              mean_between(cone.heights, west, -1.0, 60.0) + 50.0)
        << "the breach";
    EXPECT_GT(flank(land("cinder-cone", {stage("group[0].profile=glacial")})), 2.0);
}

TEST_F(RealisticScenes, LunarCratersAreManyAndNested) {
    // Hollows within a larger one: the way out of each leads into another's bowl.
    const auto nested = [](const std::vector<Peak>& craters) {
        return std::ranges::count_if(craters, [&](const Peak& inner) {
            return std::ranges::any_of(craters, [&](const Peak& outer) {
                const float rim = outer.height + outer.prominence;
                return outer.x == inner.parent_x && outer.y == inner.parent_y &&
                       (outer.x != inner.x || outer.y != inner.y) &&
                       inner.height + inner.prominence < rim - 10.0f;
            });
        });
    };
    const std::vector<Peak> craters = pits_of(land("lunar").heights, 12.0f);
    EXPECT_GE(craters.size(), 12u);
    EXPECT_GE(nested(craters), 4);
    std::vector<float> depths;
    for (const Peak& crater : craters) depths.push_back(crater.prominence);
    EXPECT_GT(deviation_of(depths) / mean_of(depths), 0.4) << "of varying depth";
    const Terrain without = land("lunar", {stage("group[0].circles.radius=[107,120]")});
    EXPECT_LE(nested(pits_of(without.heights, 12.0f)), 1);
}

TEST_F(RealisticScenes, MusgravesRangeStandsBehindAPlain) {
    const auto north_to_south = [](const Terrain& terrain) {
        const std::vector<float> h = all_of(terrain.heights);
        const auto third = static_cast<std::ptrdiff_t>(h.size() / 3);
        return mean_of({h.begin(), h.begin() + third}) /
               mean_of({h.end() - third, h.end()});
    };
    const Terrain range = land("musgrave");
    EXPECT_GT(north_to_south(range), 2.0);
    std::vector<float> heights;
    for (const Peak& peak : peaks_of(range.heights, 20.0f))
        heights.push_back(peak.height);
    EXPECT_GT(heights.size(), 80u);
    EXPECT_GT(deviation_of(heights) / mean_of(heights), 0.4) << "heterogeneous";
    const Terrain without = land("musgrave", {stage("group[0].cost.share=[0.9,1.0]"),
                                              stage("group[1].cost.share=[0.9,1.0]"),
                                              stage("group[1].ridges.count=0")});
    EXPECT_LT(north_to_south(without), 1.5);
}
