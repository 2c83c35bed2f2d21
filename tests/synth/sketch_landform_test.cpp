#include "synth/sketch/landform.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "field/noise.h"
#include "field/random.h"
#include "field/sample.h"
#include "synth/sketch/bands.h"

namespace cydonia::sketch {
namespace {

constexpr double kSpacing = 10.0;
constexpr int kSide = 256, kLevels = 5;

Field<float> hills() {
    NoiseOptions noise;
    noise.octaves = 6;
    noise.h = 1.0;
    return noise_field(noise, kSide, kSide, 60.0, 3);
}

Landform ridge(const std::vector<Point2>& points, double width,
               const std::function<double(double share)>& height) {
    Landform landform{geometry::shape_through(points, "ridge"), {}, {}, {}, {}};
    const int values = int(landform.shadow.length() / kSpacing) + 1;
    landform.silhouette = Field<float>(values, 1);
    for (int i = 0; i < values; ++i)
        landform.silhouette[std::size_t(i)] = float(height(double(i) / (values - 1)));
    landform.boundary = [width](double) { return std::array{width, width}; };
    return landform;
}

void deform(Field<float>& land, Landform landform) {
    landform.noise = noise_of(landform.silhouette, kLevels, false).fitted;
    sketch::deform(land, kSpacing, {&landform, 1}, kLevels, wavelets(land, kLevels, 1));
}

double hump(double share) { return 500.0 * std::sin(M_PI * share); }
// Noise, the coarser the more.
double jagged(double share) {
    double height = hump(share);
    for (int octave = 0; octave < 6; ++octave)
        height += 90.0 * std::exp2(-octave) *
                  gradient_noise(share * 5.0 * std::exp2(octave), 0.5, 7);
    return height;
}

// The most that the land is off the silhouette, away from its ends.
double off(const Field<float>& land, const Landform& landform) {
    double most = 0.0;
    const int values = landform.silhouette.width();
    for (int i = 4; i < values - 4; ++i) {
        const auto p = landform.shadow.at(landform.shadow.length() * i / (values - 1));
        const double height =
            bilinear(land, p[0] / kSpacing - 0.5, kSide - p[1] / kSpacing - 0.5);
        most = std::max(most, std::abs(height - landform.silhouette[std::size_t(i)]));
    }
    return most;
}

const std::vector<Point2> kStraight = {{400.0, 1300.0}, {2150.0, 1230.0}};
const std::vector<Point2> kBent = {
    {400.0, 700.0}, {900.0, 1500.0}, {1600.0, 1250.0}, {2100.0, 1900.0}};

TEST(Sketched, SilhouettesAreInterpolated) {
    for (const auto& points : {kStraight, kBent}) {
        const Landform landform = ridge(points, 400.0, jagged);
        Field<float> land = hills();
        EXPECT_GT(off(land, landform), 300.0);
        deform(land, landform);
        EXPECT_LT(off(land, landform), 0.005 * 500.0);
    }
}

TEST(Sketched, CanyonsAreTheSameDownwards) {
    const Landform landform =
        ridge(kBent, 300.0, [](double share) { return -0.8 * hump(share); });
    Field<float> land = hills();
    deform(land, landform);
    EXPECT_LT(off(land, landform), 0.005 * 400.0);
    EXPECT_LT(*std::ranges::min_element(land), -380.0f);
}

TEST(Sketched, NothingBeyondTheBoundaryChanges) {
    const Field<float> before = hills();
    Field<float> land = before;
    Landform landform = ridge(kStraight, 300.0, jagged);
    landform.boundary = [](double) { return std::array{300.0, 150.0}; };
    deform(land, landform);
    int changed = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double east = (x + 0.5) * kSpacing,
                         north = (kSide - y - 0.5) * kSpacing;
            // North of the way, which runs east, is left.
            const double along = 1300.0 - (east - 400.0) * 70.0 / 1750.0;
            const bool beyond = north > along + 301.0 || north < along - 151.0 ||
                                east < 99.0 || east > 2451.0;
            if (beyond) {
                ASSERT_EQ(land(x, y), before(x, y)) << x << ", " << y;
            }
            changed += land(x, y) != before(x, y);
        }
    EXPECT_GT(changed, 5000);
}

// Along the line through its ends a gentle bend has no seam on its inner side, where
// places jump from one leg to the other on the shadow itself.
TEST(Sketched, GentleBendsHaveNoSeams) {
    const std::vector<Point2> gentle = {
        {300.0, 900.0}, {1280.0, 1500.0}, {2260.0, 900.0}};
    std::vector<Point2> sharp = gentle;
    sharp[1] = {1280.0, 2300.0};
    const Landform landform =
        ridge(gentle, 700.0, [](double share) { return 200.0 + 600.0 * share; });
    ASSERT_TRUE(lies_on_base_line(landform.shadow));
    EXPECT_FALSE(lies_on_base_line(geometry::shape_through(sharp, "sharp")));
    EXPECT_FALSE(lies_on_base_line(geometry::shape_through(
        {{0.0, 0.0}, {900.0, 10.0}, {300.0, 20.0}, {1200.0, 30.0}}, "folded")));
    // Across the line below the bend's corner.
    std::vector<float> places(kSide, -1.0f);
    const int row = kSide - 1 - int(1100.0 / kSpacing);
    for (const Foot& foot : footprint(landform, Field<float>(kSide, kSide), kSpacing))
        if (int(foot.index) / kSide == row) places[foot.index % kSide] = foot.place;
    float most = 0.0f;
    for (int x = 100; x < 156; ++x) {
        ASSERT_GE(places[std::size_t(x)], 0.0f) << x;
        most = std::max(most, places[std::size_t(x)] - places[std::size_t(x) - 1]);
    }
    EXPECT_LT(most, 1.6f);  // on the shadow it jumps by tens
}

// Each of two ways that meet has its heights, and between them nothing is counted twice.
TEST(Sketched, BranchesAreOneFeature) {
    std::vector<Landform> ways = {
        ridge(kStraight, 400.0,
              [](double share) { return 400.0 * std::sin(M_PI * share); }),
        ridge({{1275.0, 1265.0}, {1700.0, 300.0}}, 400.0,
              [](double share) { return 400.0 * (1.0 - share * share); })};
    ways[1].goes_on = {true, false};
    for (Landform& way : ways)
        way.noise = noise_of(way.silhouette, kLevels, false).fitted;
    Field<float> land(kSide, kSide);
    sketch::deform(land, kSpacing, ways, kLevels, wavelets(land, kLevels, 1));
    EXPECT_LT(off(land, ways[0]), 4.0);
    // At the other's begin too, which is pinned to the first.
    for (int i = 0; i < 40; ++i) {
        const auto p = ways[1].shadow.at(i * kSpacing);
        EXPECT_NEAR(bilinear(land, p[0] / kSpacing - 0.5, kSide - p[1] / kSpacing - 0.5),
                    ways[1].silhouette[std::size_t(i)], 4.0)
            << i;
    }
    EXPECT_LT(*std::ranges::max_element(land), 410.0f);
}

// A boundary near the shadow on one side makes a cliff there.
TEST(Sketched, CloseBoundariesMakeCliffs) {
    Landform landform = ridge(kStraight, 300.0, hump);
    landform.boundary = [](double) { return std::array{500.0, 60.0}; };
    Field<float> land(kSide, kSide);
    deform(land, landform);
    double north = 0.0, south = 0.0;
    for (int y = 60; y < 200; ++y) {
        const double step = land(128, y) - land(128, y - 1);
        north = std::max(north, step), south = std::max(south, -step);
    }
    EXPECT_GT(south, 3.0 * north);
}

TEST(Sketched, LandIsAsRoughAsTheSilhouette) {
    const auto roughness = [](const std::function<double(double)>& height) {
        Field<float> land(kSide, kSide);
        deform(land, ridge(kStraight, 400.0, height));
        const auto scales = smoothed(land, kLevels);
        double squares = 0.0;
        int count = 0;
        // Beside the crest, not on it.
        for (int y = 100; y < 115; ++y)
            for (int x = 80; x < 180; ++x, ++count) {
                const double d = scales[4](x, y) - scales[2](x, y);
                squares += d * d;
            }
        return std::sqrt(squares / count);
    };
    EXPECT_GT(roughness(jagged), 3.0 * roughness(hump));
}

// White noise that halves from band to band is what the fit finds; a mouse's stroke,
// whose finest bands are shaken, is fitted by the others.
TEST(Sketched, DecayIsFitted) {
    Field<float> line(4096, 1);
    for (int band = 1; band <= 6; ++band) {
        const Field<float> noise = wavelet_noise(0, 0, 4096, 64, band, 6, 9);
        for (int x = 0; x < 4096; ++x)
            line[std::size_t(x)] += noise(x, 32) * 8.0f * std::exp2(-float(band));
    }
    const NoiseLevels noise = noise_of(line, 6, false);
    for (int band = 2; band < 6; ++band)
        EXPECT_NEAR(noise.fitted[std::size_t(band)] / noise.fitted[std::size_t(band - 1)],
                    0.5, 0.06);
    for (int x = 0; x < 4096; ++x)
        line[std::size_t(x)] += 2.0f * float(signed_unit(hash_of({std::uint64_t(x)})));
    EXPECT_LT(noise_of(line, 6, true).fitted[5],
              0.6 * noise_of(line, 6, false).fitted[5]);
}

TEST(Sketched, ThreadsDoNotMatter) {
    const auto made = [] {
        Field<float> land = hills();
        deform(land, ridge(kBent, 400.0, jagged));
        return land;
    };
    Field<float> one;
    {
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        one = made();
    }
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    EXPECT_TRUE(std::ranges::equal(one, made()));
}

}  // namespace
}  // namespace cydonia::sketch
