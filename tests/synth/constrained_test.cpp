#include "synth/pareidolia/constrained/constrained.h"
#include "field/cells_inside.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "field/noise.h"
#include "render/shadow/caster.h"
#include "render/shadow/score.h"
#include "synth/pareidolia/constrained/window.h"
#include "tests/synth/constrained_fields.h"
#include "tests/synth/target_files.h"

using namespace cydonia;
using namespace cydonia::pareidolia;

namespace {

// Land with relief at every scale; `rough` times as steep as hills are.
Terrain bumpy(int width, int height, double rough = 1.0) {
    Terrain terrain;
    terrain.spacing = 10.0;
    terrain.heights =
        noise_field({.h = 1.2, .octaves = 5, .grid = 3.0}, width, height,
                    0.08 * rough * terrain.spacing * std::max(width, height), 21);
    for (float& h : terrain.heights) h += 400.0f;
    return terrain;
}

Field<std::uint8_t> ring(int width, int height, double x, double y, double radius,
                         double hole) {
    Field<std::uint8_t> target(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const double r = std::hypot(i - x, j - y);
            target(i, j) = r < radius && r >= hole;
        }
    return target;
}

// The solver's result, and all of its messages.
struct Land {
    Terrain terrain;
    std::vector<ShadowImage> images;
    Told told;

    render::ShadowScore score(std::size_t i = 0) const {
        const render::Caster caster(terrain.heights, terrain.spacing);
        return render::score(caster.shadow(images[i].sun, 2), images[i].target,
                             images[i].window);
    }
    double iou(std::size_t i = 0) const { return score(i).iou; }
};

Land bent(const Terrain& base, std::vector<ShadowImage> images,
          const ConstrainedOptions& wishes = {}) {
    Land land{base, std::move(images), {}};
    const Context context{
        .seed = 7,
        .cast =
            [](const Terrain& terrain, const Sun& sun, int rays) {
                return render::Caster(terrain.heights, terrain.spacing).shadow(sun, rays);
            },
        .progress = &land.told};
    Options options;
    options.solver = Solver::kConstrained;
    options.constrained = wishes;
    options.images.resize(land.images.size());
    land.terrain.heights = constrained(options, base, land.images, context);
    return land;
}

bool all_finite(const Field<float>& heights) {
    return std::all_of(heights.begin(), heights.end(),
                       [](float h) { return std::isfinite(h); });
}

// The share of the land's slope there that has changed.
double changed_slope(const Field<float>& land, const Field<float>& base,
                     const Field<float>& away, float at_least) {
    double changed = 0.0, all = 0.0;
    for (int y = 0; y + 1 < base.height(); ++y)
        for (int x = 0; x + 1 < base.width(); ++x) {
            if (away(x, y) < at_least) continue;
            const double east = base(x + 1, y) - base(x, y);
            const double south = base(x, y + 1) - base(x, y);
            changed += std::hypot(land(x + 1, y) - land(x, y) - east,
                                  land(x, y + 1) - land(x, y) - south);
            all += std::hypot(east, south);
        }
    return changed / all;
}

float greatest_difference(const Field<float>& a, const Field<float>& b) {
    float most = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

std::ptrdiff_t relaxed(const std::vector<ShadowImage>& images) {
    std::ptrdiff_t cells = 0;
    for (const ShadowImage& image : images)
        cells += std::count(image.relaxed.begin(), image.relaxed.end(), 1);
    return cells;
}

class ConstrainedKeep : public TargetFiles {};

}  // namespace

TEST(Constrained, CastsABox) {
    for (const double azimuth : {0.0, 90.0, 215.0, 125.0}) {
        const Land land =
            bent(bumpy(128, 128), {image_of(box(128, 128, 40, 36, 84, 90), azimuth)});
        EXPECT_GT(land.iou(), 0.95) << azimuth;
        EXPECT_EQ(land.told.warnings, "") << azimuth;
    }
}

TEST(Constrained, CastsARingAndTheLightInIt) {
    for (const double azimuth : {0.0, 90.0, 215.0, 125.0}) {
        const Land land =
            bent(bumpy(128, 128), {image_of(ring(128, 128, 64, 62, 30, 12), azimuth)});
        EXPECT_GT(land.iou(), 0.94) << azimuth;  // a ring is mostly outline
    }
}

TEST(Constrained, CastsTwoImagesSideBySide) {
    for (const double azimuth : {0.0, 90.0, 215.0, 125.0}) {
        const Land land = bent(bumpy(128, 128),
                               {image_of(box(128, 128, 18, 44, 46, 84), azimuth),
                                image_of(box(128, 128, 84, 44, 110, 84), azimuth + 90)});
        EXPECT_GT(land.iou(0), 0.95) << azimuth;
        EXPECT_GT(land.iou(1), 0.95) << azimuth;
        EXPECT_EQ(land.told.warnings, "") << azimuth;
        EXPECT_LT(relaxed(land.images), 20) << azimuth;
    }
}

TEST(Constrained, TheBaseShowsNothingOfIt) {  // else the tests above say nothing
    Land land = bent(bumpy(128, 128), {image_of(box(128, 128, 40, 36, 84, 90), 90.0)});
    land.terrain = bumpy(128, 128);
    EXPECT_LT(land.iou(), 0.4);
}

TEST(Constrained, SaysWhereTheImageCounts) {
    const Land land = bent(bumpy(96, 64), {image_of(box(96, 64, 40, 26, 54, 40), 90.0)});
    const ShadowImage& image = land.images[0];
    ASSERT_TRUE(image.window.same_shape(image.target));
    for (std::size_t i = 0; i < image.target.size(); ++i)
        EXPECT_LE(image.target[i], image.window[i]);
    EXPECT_EQ(image.window(2, 2), 0);
}

TEST(Constrained, FarFromTheImageTheLandKeepsItsSlopes) {
    const Terrain base = bumpy(128, 128);
    for (const double azimuth : {90.0, 215.0}) {
        const Land land = bent(base, {image_of(box(128, 128, 84, 20, 104, 40), azimuth)});
        const Field<float> away = cells_inside(land.images[0].window, false);
        EXPECT_LT(changed_slope(land.terrain.heights, base.heights, away, 25.0f), 0.12);
        EXPECT_LT(changed_slope(land.terrain.heights, base.heights, away, 45.0f), 0.06);
    }
}

TEST(Constrained, OneAndFourThreadsGiveTheSameBytes) {
    Field<float> heights[2];
    for (int i = 0; i < 2; ++i) {
        tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    i == 0 ? 1 : 4);
        heights[i] = bent(bumpy(97, 80), {image_of(box(97, 80, 30, 24, 50, 50), 55.0),
                                          image_of(box(97, 80, 60, 24, 80, 50), 120.0)})
                         .terrain.heights;
    }
    EXPECT_EQ(heights[0], heights[1]);
}

TEST_F(ConstrainedKeep, WhatIsKeptIsTheBaseToTheBit) {
    for (const auto& [width, height] : {std::pair{96, 96}, {97, 61}}) {
        const Terrain base = bumpy(width, height);
        const auto kept = [&](int x, int y) {
            return x >= 2 && x < 40 && y >= 2 && y < 24;
        };
        ConstrainedOptions wishes;
        Field<std::uint8_t> grey(width, height);
        draw_box(grey, 2, 2, 40, 24, 255);
        wishes.keep = png("keep.png", grey);
        const Land land =
            bent(base, {image_of(box(width, height, 46, 26, 70, 46), 90.0)}, wishes);
        const Field<float>& heights = land.terrain.heights;
        float cliff = 0.0f;
        for (int y = 0; y + 1 < height; ++y)
            for (int x = 0; x + 1 < width; ++x) {
                if (kept(x, y)) {
                    EXPECT_EQ(heights(x, y), base.heights(x, y));
                }
                if (kept(x, y) != kept(x + 1, y))
                    cliff = std::max(cliff, std::abs(heights(x + 1, y) - heights(x, y)));
                if (kept(x, y) != kept(x, y + 1))
                    cliff = std::max(cliff, std::abs(heights(x, y + 1) - heights(x, y)));
            }
        EXPECT_LT(cliff, 2.0f * float(base.spacing));
        EXPECT_GT(land.iou(), 0.85);
    }
}

TEST_F(ConstrainedKeep, WhenAllIsKeptNothingHappens) {
    const Terrain base = bumpy(48, 40);
    ConstrainedOptions wishes;
    wishes.keep = png("keep.png", Field<std::uint8_t>(8, 8, 255));
    EXPECT_EQ(
        bent(base, {image_of(box(48, 40, 14, 14, 30, 28), 90.0)}, wishes).terrain.heights,
        base.heights);
}

TEST(ConstrainedSun, GrazingAndHigh) {
    for (const double elevation : {0.5, 3.0, 60.0, 75.0, 89.0}) {
        const Land land =
            bent(bumpy(96, 96), {image_of(box(96, 96, 30, 28, 64, 66), 90.0, elevation)});
        EXPECT_TRUE(all_finite(land.terrain.heights)) << elevation;
        if (elevation >= 3.0 && elevation <= 75.0) {
            EXPECT_GT(land.iou(), 0.85) << elevation;
        }
    }
}

TEST(ConstrainedTarget, TouchingTheFrame) {
    const auto all_sides = image_of(box(96, 80, 0, 0, 96, 80), 90.0);
    EXPECT_TRUE(all_finite(bent(bumpy(96, 80), {all_sides}).terrain.heights));
    // Away from the sun the frame is a shadow's end like others.
    const Land land = bent(bumpy(96, 80), {image_of(box(96, 80, 0, 24, 40, 80), 90.0)});
    EXPECT_GT(land.iou(), 0.93);
    // Toward it the edge's own cells cast the rest.
    const Land sunny = bent(bumpy(96, 80), {image_of(box(96, 80, 60, 24, 96, 56), 90.0)});
    EXPECT_GT(sunny.iou(), 0.9);
}

TEST(ConstrainedTarget, OfOnePixel) {
    for (const double azimuth : {90.0, 35.0}) {
        const Land land =
            bent(bumpy(96, 80), {image_of(box(96, 80, 50, 40, 51, 41), azimuth)});
        EXPECT_GE(land.score().recall, 0.5) << azimuth;
    }
}

TEST(ConstrainedTarget, OfLinesOneCellWide) {
    for (const double azimuth : {90.0, 35.0}) {
        Field<std::uint8_t> target(96, 80);
        for (int i = 0; i < 40; ++i)
            target(28 + i, 20 + i) = target(28 + i, 40) = target(48, 20 + i) = 1;
        const Land land = bent(bumpy(96, 80), {image_of(target, azimuth)});
        EXPECT_GT(land.score().recall, 0.75) << azimuth;
        EXPECT_GT(land.score().precision, 0.6) << azimuth;
    }
}

TEST(ConstrainedTarget, OfNothingLeavesTheLandAsItIs) {
    for (const auto& [width, height] : {std::pair{96, 80}, {97, 61}}) {
        const Terrain base = bumpy(width, height);
        const Land land =
            bent(base, {image_of(Field<std::uint8_t>(width, height), 90.0)});
        EXPECT_LT(greatest_difference(land.terrain.heights, base.heights), 0.1f);
    }
}

TEST(ConstrainedGrid, OfAnyShape) {
    for (const auto& [width, height] :
         {std::pair{97, 61}, {61, 97}, {200, 48}, {16, 16}, {67, 67}, {129, 65}})
        for (const double azimuth : {90.0, 215.0}) {
            const Land land = bent(bumpy(width, height),
                                   {image_of(box(width, height, width / 3, height / 3,
                                                 2 * width / 3, 2 * height / 3),
                                             azimuth)});
            EXPECT_GT(land.iou(), width * height < 1000 ? 0.65 : 0.92)
                << width << " x " << height << " " << azimuth;
        }
}

TEST(ConstrainedGrid, OfNextToNothing) {
    for (const auto& [width, height] :
         {std::pair{2, 2}, {3, 2}, {2, 40}, {40, 2}, {300, 3}, {5, 5}})
        for (const double azimuth : {0.0, 90.0, 35.0, 215.0}) {
            const Land land =
                bent(bumpy(width, height),
                     {image_of(box(width, height, 0, 0, width / 2, 1), azimuth)});
            EXPECT_TRUE(all_finite(land.terrain.heights)) << width << " x " << height;
        }
}

TEST(ConstrainedBase, TooRoughToBeLitSaysSo) {
    const auto image = image_of(ring(96, 96, 48, 48, 24, 8), 90.0, 15.0);
    EXPECT_EQ(bent(bumpy(96, 96, 0.5), {image}).told.notes, "");
    const Land land = bent(bumpy(96, 96, 10.0), {image});
    EXPECT_TRUE(contains(land.told.notes, "too rough")) << land.told.notes;
    EXPECT_TRUE(contains(land.told.notes, "%")) << land.told.notes;
    EXPECT_GT(land.iou(), 0.85);
}

TEST(ConstrainedBase, FlatLandWillDo) {
    Terrain flat;
    flat.heights = Field<float>(96, 96);
    flat.spacing = 10.0;
    const Land land = bent(flat, {image_of(box(96, 96, 30, 28, 64, 66), 35.0)});
    EXPECT_GT(land.iou(), 0.94);
}

TEST(ConstrainedSuns, ThatContradictSaySoAndWhere) {
    const Land land = bent(bumpy(96, 96), {image_of(ring(96, 96, 48, 48, 26, 10), 0.0),
                                           image_of(box(96, 96, 30, 30, 66, 66), 270.0)});
    EXPECT_TRUE(contains(land.told.warnings, "contradict")) << land.told.warnings;
    EXPECT_GT(relaxed(land.images), 0);
    EXPECT_TRUE(contains(land.told.warnings,
                         fmt::format("{} cells are relaxed", relaxed(land.images))));
    EXPECT_GT(land.iou(0), 0.5);
    EXPECT_GT(land.iou(1), 0.5);
}

TEST(ConstrainedSuns, OneAfterTheOtherShowMore) {
    // Nested: what the low sun shades contains what the high one does.
    const Land land =
        bent(bumpy(96, 96), {image_of(box(96, 96, 28, 30, 68, 66), 90.0, 12.0),
                             image_of(box(96, 96, 48, 30, 68, 66), 90.0, 25.0)});
    EXPECT_GT(land.iou(0), 0.93);
    EXPECT_GT(land.iou(1), 0.93);
}

TEST(ConstrainedWishes, AnyMixOfThemCasts) {
    for (const ConstrainedOptions& wishes : {ConstrainedOptions{0.0, 0.0, 0.0, {}},
                                             {3.0, 0.0, 0.0, {}},
                                             {0.5, 5.0, 0.0, {}},
                                             {1.0, 1.0, 5.0, {}},
                                             {1.0, 0.0, 1.0, {}}}) {
        const Land land =
            bent(bumpy(96, 96), {image_of(box(96, 96, 30, 28, 64, 66), 125.0)}, wishes);
        EXPECT_GT(land.iou(), 0.85)
            << wishes.faithful << ", " << wishes.natural << ", " << wishes.hidden;
    }
}
