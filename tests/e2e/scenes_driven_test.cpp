// The image-driven and sketch-based landscapes of Rusnell 2009, sections 4.3 and 4.4:
// each test measures what the thesis calls characteristic of one, and that it goes when
// its cause is taken away.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "field/dem.h"
#include "field/strokes.h"
#include "tests/app/program.h"
#include "tests/e2e/land_measures.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

using Changes = std::vector<std::string>;

constexpr Rgb8 kBlack{0, 0, 0}, kRed{255, 0, 0}, kGreen{0, 160, 0}, kBlue{0, 0, 255};

Source file_of(const std::string& folder, const std::string& name) {
    return open_source(fs::path(CYDONIA_SOURCE_DIR) / "scenes" / folder / name);
}
Source texture(const std::string& name) { return file_of("textures", name); }

// KEY=VALUE of the scene's one stage, as after --set.
std::string stage(const std::string& change) { return "terrain.stage[0]." + change; }

struct DrivenScenes : testing::Test {
    TemporaryFolder folder;
    int lands = 0;
    int features = 0;  // of the last land

    Terrain land(const std::string& scene, const Changes& changes = {},
                 int samples = 256) {
        const fs::path out = folder / (scene + std::to_string(lands++));
        std::vector<std::string> arguments{"synth",
                                           file_of(scene, "scene.toml").path.string(),
                                           "--explain",
                                           "-o",
                                           out.string(),
                                           "--set",
                                           "terrain.samples=" + std::to_string(samples)};
        for (const std::string& change : changes) {
            arguments.push_back("--set");
            arguments.push_back(change);
        }
        const Outcome outcome = run({folder.path()}, arguments);
        if (outcome.code != 0) throw std::runtime_error(outcome.err);
        std::ifstream table(out / "explain/1-features.csv");
        features = -1;  // the line of names
        for (std::string line; std::getline(table, line);) ++features;
        return read_dem(open_source(out / "terrain.exr"));
    }
};

// Pearson's.
double correlation(const std::vector<float>& a, const std::vector<float>& b) {
    const double mean_a = mean_of(a), mean_b = mean_of(b);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - mean_a) * (b[i] - mean_b);
    return sum / (static_cast<double>(a.size()) * deviation_of(a) * deviation_of(b));
}

std::vector<float> all_of(const Field<float>& field) {
    return {field.begin(), field.end()};
}

// Of the steepness of the land with the grey of a picture, both over about 60 m.
double steep_where_bright(const Terrain& terrain, const Source& picture) {
    const int side = 88;
    const Field<float> grey = read_grey_at(picture, side, side);
    return correlation(all_of(resized(slopes_of(terrain), side, side)), all_of(grey));
}

// Sobel's edges, half way between the faintest gradient and the strongest (eq. 4.3), on
// the land's samples.
Field<std::uint8_t> edges_of(const Source& picture, const Field<float>& shape) {
    const Field<float> g = read_grey(picture);
    Field<float> gradients(g.width(), g.height());
    for (int y = 1; y + 1 < g.height(); ++y)
        for (int x = 1; x + 1 < g.width(); ++x)
            gradients(x, y) =
                std::hypot(g(x + 1, y - 1) + 2 * g(x + 1, y) + g(x + 1, y + 1) -
                               g(x - 1, y - 1) - 2 * g(x - 1, y) - g(x - 1, y + 1),
                           g(x - 1, y + 1) + 2 * g(x, y + 1) + g(x + 1, y + 1) -
                               g(x - 1, y - 1) - 2 * g(x, y - 1) - g(x + 1, y - 1));
    const auto [least, most] = std::ranges::minmax(gradients);
    Field<std::uint8_t> edges(shape.width(), shape.height());
    for (int y = 0; y < g.height(); ++y)
        for (int x = 0; x < g.width(); ++x)
            if (gradients(x, y) >= 0.5f * (least + most))
                edges(x * shape.width() / g.width(), y * shape.height() / g.height()) = 1;
    return edges;
}

// Heights without what is wider than about 400 m.
Field<float> relief_of(const Field<float>& heights) {
    Field<float> relief = heights;
    const Field<float> wide =
        resized(resized(heights, 12, 12), heights.width(), heights.height());
    std::ranges::transform(relief, wide, relief.begin(), std::minus{});
    return relief;
}

// How much higher the land is on these cells than 100 to 200 m from them, in deviations
// of its relief.
double prominence(const Terrain& terrain, const Field<std::uint8_t>& cells) {
    const Field<float> relief = relief_of(terrain.heights);
    const Field<float> away = distances_to(cells, terrain.spacing);
    return (mean_of(values_between(relief, away, -1.0, 0.0)) -
            mean_of(values_between(relief, away, 100.0, 200.0))) /
           deviation_of(all_of(relief));
}

// Of the values where a sketch has this colour.
double mean_under(const Field<float>& values, const std::string& scene, Rgb8 colour) {
    const Field<Rgba8> sketch =
        read_strokes(file_of(scene, "strokes.svg"), values.width(), values.height());
    std::vector<float> found;
    for (std::size_t i = 0; i < sketch.size(); ++i)
        if (sketch[i] == Rgba8{colour[0], colour[1], colour[2], 255})
            found.push_back(values[i]);
    return mean_of(found);
}

// Of the land between two places in shares of its width, from the north-west corner.
double mean_within(const Terrain& terrain, std::array<double, 2> from,
                   std::array<double, 2> to) {
    const Field<float>& h = terrain.heights;
    std::vector<float> found;
    for (int y = int(from[1] * h.height()); y < int(to[1] * h.height()); ++y)
        for (int x = int(from[0] * h.width()); x < int(to[0] * h.width()); ++x)
            found.push_back(h(x, y));
    return mean_of(found);
}

}  // namespace

TEST_F(DrivenScenes, RidgesFollowTheEdgesOfRippledWater) {
    const Terrain ripples = land("edge-detection");
    EXPECT_NEAR(features, 288, 15) << "table A.1";
    const Field<std::uint8_t> crests =
        edges_of(texture("rippled-water.jpg"), ripples.heights);
    EXPECT_GT(prominence(ripples, crests), 0.9);
    const Terrain rocks = land(
        "edge-detection", {stage("group[0].edges.image=../textures/river-rocks.jpg")});
    EXPECT_LT(prominence(rocks, crests), 0.3);
}

TEST_F(DrivenScenes, LeavesAreSeenInTheSlopes) {
    const Terrain leaves = land("edge-weights");
    EXPECT_EQ(features, 7) << "table A.1";
    EXPECT_GT(steep_where_bright(leaves, texture("leaves.svg")), 0.5);
    const Terrain gravel =
        land("edge-weights", {stage("edge_weights.image=../textures/gravel.svg")});
    EXPECT_LT(steep_where_bright(gravel, texture("leaves.svg")), 0.1);
}

TEST_F(DrivenScenes, GravelIsApparent) {
    const Terrain gravel = land("edge-detection-and-weights-1");
    EXPECT_NEAR(features, 54, 3) << "table A.1";
    EXPECT_GT(steep_where_bright(gravel, texture("gravel.svg")), 0.5);
    EXPECT_GT(prominence(gravel, edges_of(texture("hay-bales.jpg"), gravel.heights)),
              0.8);
    EXPECT_LT(
        steep_where_bright(land("edge-detection-and-weights-1",
                                {stage("edge_weights.image=../textures/leaves.svg")}),
                           texture("gravel.svg")),
        0.1);
}

// The grain of the slopes, less than gravel's: section 4.3.3. Another's pictures do not
// show.
TEST_F(DrivenScenes, BirchesAndCloudsAreSubtle) {
    const double apparent = steep_where_bright(
        land("edge-detection-and-weights-1", {}, 128), texture("gravel.svg"));
    const struct {
        const char *scene, *weights, *other_weights, *edges, *other_edges;
        int features;
    } kCases[] = {{"edge-detection-and-weights-2", "birches.svg", "mammatus.svg",
                   "rainbow-beads.jpg", "river-rocks.jpg", 229},
                  {"edge-detection-and-weights-3", "birches.svg", "mammatus.svg",
                   "river-rocks.jpg", "rainbow-beads.jpg", 344},
                  {"edge-detection-and-weights-4", "mammatus.svg", "birches.svg",
                   "rainbow-beads.jpg", "river-rocks.jpg", 229}};
    for (const auto& c : kCases) {
        SCOPED_TRACE(c.scene);
        const Terrain terrain = land(c.scene, {}, 128);
        EXPECT_NEAR(features, c.features, 0.05 * c.features) << "table A.1";
        const double subtle = steep_where_bright(terrain, texture(c.weights));
        EXPECT_GT(subtle, 0.25);
        EXPECT_LT(subtle, 0.9 * apparent);
        EXPECT_LT(steep_where_bright(terrain, texture(c.other_weights)), 0.1);
        const auto edges = [&](const char* picture) {
            return prominence(terrain, edges_of(texture(picture), terrain.heights));
        };
        EXPECT_GT(edges(c.edges), 0.35);
        EXPECT_LT(edges(c.other_edges), 0.2);
    }
}

TEST_F(DrivenScenes, LettersStandAboveTheirSurroundings) {
    const struct {
        const char *scene, *other;
        int features;
    } kCases[] = {{"u-of-s", "img-logo", 22},
                  {"img-logo", "lambda", 16},
                  {"lambda", "img-logo", 3}};
    for (const auto& c : kCases) {
        const Terrain terrain = land(c.scene);
        EXPECT_EQ(features, c.features) << "table A.1";
        const auto letters = [&](const char* scene) {
            return prominence(terrain,
                              drawn(file_of(scene, "letters.svg"), terrain.heights));
        };
        EXPECT_GT(letters(c.scene), 0.95) << c.scene;
        EXPECT_LT(letters(c.other), 0.6) << "the letters of " << c.other;
    }
}

TEST_F(DrivenScenes, Sketch1HasARangeAValleyAndHills) {
    const Terrain terrain = land("sketch-1");
    EXPECT_EQ(features, 31) << "table A.1";
    const auto red_over_black = [&](const Field<float>& values) {
        return mean_under(values, "sketch-1", kRed) /
               mean_under(values, "sketch-1", kBlack);
    };
    EXPECT_GT(red_over_black(terrain.heights), 2.0);
    EXPECT_GT(red_over_black(slopes_of(terrain)), 1.2) << "steep against smooth";
    const double valley = mean_within(terrain, {0.0, 0.48}, {1.0, 0.53});
    EXPECT_LT(valley, 0.2 * mean_within(terrain, {0.0, 0.05}, {1.0, 0.3}));
    EXPECT_LT(valley, 0.5 * mean_within(terrain, {0.0, 0.6}, {1.0, 0.95}));
    EXPECT_LT(red_over_black(
                  land("sketch-1", {stage("group[0].cost.share=[0.85,1.0]")}).heights),
              1.5);
}

TEST_F(DrivenScenes, Sketch2HasTiersAboveRidgesAboveHills) {
    const auto falls = [](const Terrain& terrain) {
        const double green = mean_under(terrain.heights, "sketch-2", kGreen),
                     black = mean_under(terrain.heights, "sketch-2", kBlack),
                     red = mean_under(terrain.heights, "sketch-2", kRed),
                     blue = mean_under(terrain.heights, "sketch-2", kBlue);
        return green > 1.5 * black && black > 1.3 * red && red > 1.1 * blue;
    };
    EXPECT_TRUE(falls(land("sketch-2")));
    EXPECT_EQ(features, 58) << "table A.1";
    EXPECT_FALSE(falls(land("sketch-2", {stage("group[3].cost.share=[0.6,0.7]")})));
}

TEST_F(DrivenScenes, Sketch3HasTwoRangesOverAValley) {
    const Terrain terrain = land("sketch-3");
    EXPECT_EQ(features, 38) << "table A.1";
    const double valley = mean_within(terrain, {0.4, 0.0}, {0.6, 1.0});
    EXPECT_LT(valley, 0.3 * mean_within(terrain, {0.05, 0.0}, {0.2, 1.0}));
    EXPECT_LT(valley, 0.3 * mean_within(terrain, {0.8, 0.0}, {0.95, 1.0}));
    const auto rough_over_smooth = [](const Terrain& t) {
        return mean_under(slopes_of(t), "sketch-3", kRed) /
               mean_under(slopes_of(t), "sketch-3", kBlue);
    };
    EXPECT_GT(rough_over_smooth(terrain), 1.5);
    EXPECT_LT(rough_over_smooth(land("sketch-3", {stage("group[1].cost.share=[0.85,1.0]"),
                                                  stage("group[1].profile=hill")})),
              1.3);
}

TEST_F(DrivenScenes, Sketch4RisesToTheMiddle) {
    const auto rise = [](const Terrain& terrain) {
        const Field<std::uint8_t> strokes =
            drawn(file_of("sketch-4", "strokes.svg"), terrain.heights);
        std::vector<float> heights, distances;
        for (int y = 0; y < strokes.height(); ++y)
            for (int x = 0; x < strokes.width(); ++x)
                if (strokes(x, y)) {
                    heights.push_back(terrain.heights(x, y));
                    distances.push_back(float(std::hypot(x - 0.5 * strokes.width(),
                                                         y - 0.5 * strokes.height())));
                }
        return -correlation(heights, distances);
    };
    EXPECT_GT(rise(land("sketch-4")), 0.9);
    EXPECT_EQ(features, 15) << "table A.1";
    const std::string corner = ".cost.centre=[0.0,0.0]";
    EXPECT_LT(
        rise(land("sketch-4", {stage("group[0]" + corner), stage("group[1]" + corner)})),
        0.5);
}
