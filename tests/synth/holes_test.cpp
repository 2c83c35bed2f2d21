// Rusnell 2009, section 5.3.2: holes of light in a shadow.
#include "synth/pareidolia/holes.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <utility>

#include "render/shadow/caster.h"
#include "render/shadow/score.h"
#include "synth/pareidolia/features.h"
#include "synth/pareidolia/shadow_lines.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

// A disc with two eyes, of which the right one has a pupil.
Field<std::uint8_t> face(int side) {
    const auto disc = [&](int x, int y, double cx, double cy, double r) {
        return std::hypot((x + 0.5) / side - cx, (y + 0.5) / side - cy) < r;
    };
    Field<std::uint8_t> image(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            image(x, y) = disc(x, y, 0.5, 0.5, 0.34) && !disc(x, y, 0.35, 0.45, 0.08) &&
                          (!disc(x, y, 0.64, 0.45, 0.1) || disc(x, y, 0.64, 0.45, 0.03));
    return image;
}

// A dark rectangle, 10 to 50 by 10 to 40, with a hole, 26 to 34 by 20 to 30.
Field<std::uint8_t> box_with_hole() {
    Field<std::uint8_t> image(64, 64);
    for (int y = 10; y < 40; ++y)
        for (int x = 10; x < 50; ++x)
            image(x, y) = y < 20 || y >= 30 || x < 26 || x >= 34;
    return image;
}

// What the light falls over a sample of the light frame: outlines are no finer.
double sample(const ShadowPlan& plan) { return 1.01 * plan.rise / plan.frame.density; }

ShadowImage image_of(Field<std::uint8_t> target, double azimuth, double elevation) {
    ShadowImage image;
    image.target = std::move(target);
    image.sun = {radians(azimuth), radians(elevation)};
    return image;
}

Terrain face_land(const ShadowImage& image, Holes holes) {
    const int side = image.target.width();
    Terrain flat;
    flat.heights = Field<float>(side, side);
    flat.spacing = 5120.0 / side;
    Options options;
    options.features.mean_edge_weight = 1.2;
    options.features.edge_weight_deviation = 0.8;
    options.features.holes = holes;
    SilentProgress silent;
    Terrain land = flat;
    land.heights =
        features(options, flat, image, {.seed = 7, .cast = {}, .progress = &silent});
    return land;
}

}  // namespace

TEST(ShadowLines, WithoutHolesAreTheCrestsOfSection5_3_1) {
    Field<std::uint8_t> target(64, 64);
    for (int y = 10; y < 40; ++y)
        for (int x = 20; x < 44; ++x) target(x, y) = 1;
    const ShadowImage image = image_of(target, 65.0, 30.0);
    const ShadowPlan plan = shadow_plan(image, 10.0);
    Field<float> ground(64, 64);
    for (std::size_t i = 0; i < ground.size(); ++i) ground[i] = static_cast<float>(i % 7);
    const auto lines = lines_of_regions(plan, region_tree(target), ground, 5.0, 0.5);
    const auto crests = lines_of_runs(plan, ground).crests;
    ASSERT_EQ(lines.crests.size(), crests.size());
    for (std::size_t i = 0; i < crests.size(); ++i)
        EXPECT_NEAR(lines.crests[i], crests[i], 0.01);
    for (float hole : lines.holes) EXPECT_EQ(hole, kNowhere);
}

TEST(ShadowLines, TheThesisHolesAreJustAboveTheLineOfTheWholeShadow) {
    const ShadowImage image = image_of(box_with_hole(), 90.0, 30.0);
    const ShadowPlan plan = shadow_plan(image, 10.0);
    const auto lines = lines_of_regions(plan, region_tree(image.target),
                                        Field<float>(64, 64, 100.0f), 5.0, 1.0);
    for (std::size_t i = 0; i < plan.runs.size(); ++i) {
        const GridPoint start = plan.start(plan.runs[i]);
        if (start.x < 40.0) continue;  // a shadow behind the hole
        const bool hole = start.y > 19.8 && start.y < 29.2;
        if (!hole && start.y > 19.2 && start.y < 29.8) continue;
        EXPECT_NEAR(lines.crests[i], 100.0 + 40.0 * plan.rise - (hole ? 5.0 : 0.0),
                    sample(plan));
    }
    for (int x = 26; x < 34; ++x)  // the shadow ends at 10; its line rises to the east
        EXPECT_NEAR(lines.holes(x, 24), 100.0 + plan.rise * (x + 0.5 - 10.0),
                    sample(plan))
            << x;
    EXPECT_EQ(lines.holes(20, 24), kNowhere);
}

TEST(ShadowLines, GentlerHolesLowerTheCrestByWhatTheyGain) {
    const ShadowImage image = image_of(box_with_hole(), 90.0, 30.0);
    const ShadowPlan plan = shadow_plan(image, 10.0);
    const auto lines = lines_of_regions(plan, region_tree(image.target),
                                        Field<float>(64, 64, 100.0f), 0.0, 0.0);
    for (int x = 26; x < 34; ++x)  // level ground, 16 cells before the end
        EXPECT_NEAR(lines.holes(x, 24), 100.0 + 16.0 * plan.rise, sample(plan)) << x;
    for (std::size_t i = 0; i < plan.runs.size(); ++i) {
        const GridPoint start = plan.start(plan.runs[i]);
        if (start.y < 20.0 || start.y > 29.0) continue;
        const double cells = start.x > 40.0 ? 32.0 : 16.0;  // all but the hole's 8
        EXPECT_NEAR(lines.crests[i], 100.0 + cells * plan.rise, sample(plan));
    }
}

TEST(Holes, AnEyeIsLitTheHeadAroundItAndItsPupilAreDark) {
    for (double azimuth : {0.0, 30.0, 250.0}) {
        const ShadowImage image = image_of(face(160), azimuth, 25.0);
        const Terrain land = face_land(image, Holes::kIterative);
        const auto cast = render::Caster(land.heights, land.spacing).shadow(image.sun, 2);
        const auto dark = [&](double x, double y) {
            double sum = 0.0;
            for (int j = -3; j <= 3; ++j)
                for (int i = -3; i <= 3; ++i)
                    sum += cast(static_cast<int>(320 * x) + i,
                                static_cast<int>(320 * y) + j);
            return sum / 49.0;
        };
        EXPECT_LT(dark(0.35, 0.45), 0.1) << azimuth;
        using Point = std::pair<double, double>;
        for (const auto& [x, y] :
             {Point{0.24, 0.45}, Point{0.46, 0.45}, Point{0.35, 0.32}, Point{0.35, 0.58},
              Point{0.64, 0.45}})
            EXPECT_GT(dark(x, y), 0.9) << azimuth << ": " << x << ", " << y;
        const auto score = render::score(cast, image.target);
        EXPECT_GT(score.iou, 0.88) << azimuth;
        EXPECT_GT(score.recall, 0.95) << azimuth;
    }
}

TEST(Holes, OneAndFourThreadsGiveTheSameBytes) {
    const ShadowImage image = image_of(face(96), 55.0, 25.0);
    Field<float> heights[2];
    for (int i = 0; i < 2; ++i) {
        tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    i == 0 ? 1 : 4);
        heights[i] = face_land(image, Holes::kIterative).heights;
    }
    EXPECT_EQ(heights[0], heights[1]);
}

TEST(Holes, PointsAreAsManyAsAQuarterOfTheNodes) {
    Field<float> holes(256, 256, kNowhere);
    int nodes = 0;
    for (int y = 40; y < 200; ++y)
        for (int x = 30; x < 150; ++x, ++nodes) holes(x, y) = 7.0f;
    const Field<float> points = hole_points(holes, 1);
    int count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i] == kNowhere) continue;
        EXPECT_EQ(points[i], holes[i]);
        ++count;
    }
    // Random points partly coincide: 1 - exp(-1/4) of the cells have one.
    EXPECT_NEAR(static_cast<double>(count) / nodes, 0.2212, 0.01);
}

TEST(Holes, FilledShadowsAreWithoutHoles) {
    const auto filled = filled_shadows(region_tree(box_with_hole()));
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            EXPECT_EQ(filled(x, y), x >= 10 && x < 50 && y >= 10 && y < 40);
}
