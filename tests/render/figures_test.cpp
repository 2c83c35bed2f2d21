// Figures of shadow images against what must be true.
#include "render/shadow/figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "field/error.h"
#include "render/shadow/distractors.h"
#include "render/shadow/lineup.h"
#include "render/shadow/outline.h"
#include "render/shadow/soft.h"
#include "render/shadow/sun_clock.h"
#include "tests/render/shadow_land.h"

namespace cydonia::render {
namespace {

// 1 in columns [left, right) and rows [top, bottom).
Mask box(int width, int height, int left, int top, int right, int bottom) {
    Mask mask(width, height);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) mask(x, y) = 1;
    return mask;
}

Mask joined(Mask a, const Mask& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] |= b[i];
    return a;
}

Mask inverted(Mask mask) {
    for (auto& m : mask) m = !m;
    return mask;
}

TEST(Window, OnlyItsCellsCount) {
    const Mask target = box(20, 20, 5, 5, 10, 10);
    const Mask window = box(20, 20, 0, 0, 12, 20);
    const Mask cast = joined(target, box(20, 20, 12, 0, 20, 20));
    EXPECT_LT(score(cast, target).iou, 0.2);
    EXPECT_EQ(score(cast, target, window).iou, 1.0);
    EXPECT_EQ(score(repeated(cast, 3), target, window).iou, 1.0);
    EXPECT_EQ(outline_score(cast, target, window), 1.0);
    EXPECT_EQ(correlation(cast, target, window), 1.0);
    EXPECT_LT(outline_score(cast, target), 0.9);
    EXPECT_THROW(score(cast, target, Mask(20, 19)), Error);
    EXPECT_THROW(outline_score(cast, target, Mask(10, 10)), Error);
    EXPECT_THROW(thin_recall(cast, target, Mask(21, 20)), Error);
    EXPECT_THROW(correlation(cast, Mask(3, 3)), Error);
}

TEST(Outline, OneCellOffIsNearThreeAreNot) {
    const Mask target = box(40, 30, 10, 0, 20, 30);
    EXPECT_EQ(outline_score(repeated(target, 2), target), 1.0);
    EXPECT_EQ(outline_score(repeated(box(40, 30, 11, 0, 21, 30), 2), target), 1.0);
    EXPECT_EQ(outline_score(repeated(box(40, 30, 13, 0, 23, 30), 2), target), 0.0);
    // One edge of two is right: half of either outline is near the other.
    EXPECT_NEAR(outline_score(repeated(box(40, 30, 10, 0, 26, 30), 2), target), 0.5,
                1e-9);
    EXPECT_EQ(outline_score(Mask(40, 30), Mask(40, 30)), 1.0);
    EXPECT_EQ(outline_score(Mask(40, 30), target), 0.0);
}

TEST(ThinParts, AreThoseBelowFourCells) {
    const Mask broad = box(60, 40, 5, 5, 25, 35), three = box(60, 40, 40, 5, 43, 35);
    const Mask both = joined(broad, three);
    // A disc does not reach into the corners.
    EXPECT_NEAR(thin_recall(repeated(broad, 2), both).value(), 0.0, 0.1);
    EXPECT_NEAR(thin_recall(repeated(three, 2), both).value(), 1.0, 0.1);
    EXPECT_EQ(thin_recall(repeated(both, 4), both), 1.0);
    EXPECT_EQ(thin_recall(Mask(60, 40), box(60, 40, 10, 0, 14, 40)), std::nullopt);
    EXPECT_EQ(thin_recall(Mask(60, 40), box(60, 40, 10, 0, 13, 40)), 0.0);
    EXPECT_EQ(thin_recall(Mask(60, 40), Mask(60, 40)), std::nullopt);
    EXPECT_EQ(thin_recall(Mask(60, 40), three, box(60, 40, 0, 0, 30, 40)), std::nullopt);
}

TEST(Correlation, OfMasks) {
    const Mask a = box(10, 10, 0, 0, 5, 10), b = box(10, 10, 0, 0, 10, 5);
    EXPECT_DOUBLE_EQ(correlation(a, a), 1.0);
    EXPECT_DOUBLE_EQ(correlation(a, inverted(a)), -1.0);
    EXPECT_DOUBLE_EQ(correlation(a, b), 0.0);
    EXPECT_EQ(correlation(a, Mask(10, 10)), 0.0);
}

TEST(LandFigures, OfASpike) {
    Field<float> heights(30, 24);
    heights(15, 12) = 7.0f;
    const LandFigures figures = land_figures(heights, 10.0);
    EXPECT_EQ(figures.range, 7.0);
    // The Laplacian is -4, four times 1 and 0: moments 20/n and 260/n.
    const double n = 26.0 * 20.0;
    EXPECT_NEAR(figures.kurtosis, 260.0 / n / (20.0 / n * 20.0 / n) - 3.0, 1e-9);
    heights(15, 12) = 0.0f;
    heights(1, 12) = 7.0f;  // only its neighbour to the east counts
    EXPECT_NEAR(land_figures(heights, 10.0).kurtosis, n * n / (n - 1.0) - 6.0, 1e-6);
}

TEST(LandFigures, OfAPlane) {
    const auto plane =
        land(40, 30, 10.0, [](double x, double y) { return 0.3 * x - 0.4 * y; });
    EXPECT_NEAR(land_figures(plane, 10.0).slope, 0.5, 1e-4);
    const LandFigures flat = land_figures(Field<float>(5, 5), 1.0);
    EXPECT_EQ(flat.slope, 0.0);
    EXPECT_EQ(flat.kurtosis, 0.0);
    EXPECT_THROW(land_figures(Field<float>(4, 9), 1.0), Error);
}

TEST(LandFigures, SlopeLeavesOneInAHundred) {
    Field<float> heights(200, 50);
    for (int y = 0; y < 50; ++y)
        for (int x = 199; x < 200; ++x) heights(x, y) = 100.0f;  // 1 of 199 squares
    EXPECT_EQ(land_figures(heights, 1.0).slope, 0.0);
    for (int y = 0; y < 50; ++y)
        for (int x = 196; x < 200; ++x)
            heights(x, y) = 100.0f * static_cast<float>(x - 195);
    EXPECT_GT(land_figures(heights, 1.0).slope, 50.0);
}

// A wall across flat ground, light from the west.
struct Wall {
    explicit Wall(double elevation, double length) : sun(sun_at(270.0, elevation)) {
        heights = Field<float>(500, 24);
        for (int y = 0; y < 24; ++y)
            heights(20, y) = static_cast<float>(length * std::tan(sun.elevation));
    }
    Sun sun;
    Field<float> heights;
};

TEST(SoftSun, PenumbraIsAsWideAsTheDiscMakesIt) {
    for (const double elevation : {15.0, 25.0, 45.0}) {
        const Wall wall(elevation, 300.0);
        const Caster caster(wall.heights, 1.0);
        const auto hidden = hidden_sun(caster, wall.sun, 4);
        int part = 0, dark = 0, y = hidden.height() / 2;
        for (int x = 200 * 4; x < hidden.width(); ++x) {
            part += hidden(x, y) > 0 && hidden(x, y) < kDiscDirections;
            dark += hidden(x, y) == kDiscDirections;
        }
        EXPECT_GT(dark, 0);
        const double wide = 2.0 * 300.0 * 0.0093 / std::sin(2.0 * wall.sun.elevation);
        // The outermost directions stand for a ring of the disc.
        EXPECT_NEAR(part / 4.0, 0.95 * wide, 0.07 * wide + 0.25) << elevation;
    }
}

TEST(SoftSun, HalfLightIsTheHardEdge) {
    const Wall wall(25.0, 300.0);
    const Caster caster(wall.heights, 1.0);
    const Mask soft = soft_shadow(caster, wall.sun, 2), hard = caster.shadow(wall.sun, 2);
    EXPECT_GT(score(soft, Mask(hard)).iou, 0.997);
    EXPECT_GT(area(hard), area(Mask(hard.width(), hard.height(), 1)) / 2);
}

TEST(SoftSun, CastsWhatMattersOnly) {
    const Field<float> heights = fractal(60, 50, 40.0f, 9);
    const Caster caster(heights, 1.0);
    const Sun sun = sun_at(120.0, 20.0);
    const Mask hard = caster.shadow(sun, 2);
    EXPECT_EQ(caster.shadow(sun, 2, Mask(60, 50, 1)), hard);
    EXPECT_EQ(area(caster.shadow(sun, 2, Mask(60, 50))), 0u);
    const Mask where = box(60, 50, 11, 7, 32, 29);
    const Mask some = caster.shadow(sun, 2, where);
    for (int y = 14; y < 58; ++y)
        for (int x = 22; x < 64; ++x) ASSERT_EQ(some(x, y), hard(x, y));
    EXPECT_EQ(some(100, 90), 0);
    EXPECT_THROW(caster.shadow(sun, 2, Mask(50, 60)), Error);
}

TEST(OutlineShading, SeesACliffAndNothingElse) {
    const Mask target = box(80, 60, 20, 15, 60, 45);
    const Mask near = near_outline(target);
    EXPECT_EQ(near(20, 30), 1);
    EXPECT_EQ(near(21, 30), 1);
    EXPECT_EQ(near(22, 30), 0);
    EXPECT_EQ(near(18, 30), 1);
    EXPECT_EQ(near(17, 30), 0);
    const Sun sun = sun_at(300.0, 30.0);
    const Field<float> rough = fractal(80, 60, 8.0f, 3);
    EXPECT_NEAR(outline_shading(rough, 1.0, sun, near), 1.0, 0.2);
    Field<float> cliff = rough;
    for (std::size_t i = 0; i < cliff.size(); ++i) cliff[i] += 6.0f * target[i];
    EXPECT_GT(outline_shading(cliff, 1.0, sun, near), 1.5);
    EXPECT_EQ(outline_shading(Field<float>(80, 60), 1.0, sun, near), 1.0);
    EXPECT_EQ(outline_shading(rough, 1.0, sun, near_outline(Mask(80, 60))), 1.0);
    EXPECT_THROW(outline_shading(rough, 1.0, sun, Mask(60, 80)), Error);
}

TEST(Distractors, AreTwentyOfManyKinds) {
    const auto all = distractors(300, 200);
    ASSERT_EQ(all.size(), 20u);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_GT(area(all[i]), 600u) << i;
        EXPECT_LT(area(all[i]), 24000u) << i;
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_LT(correlation(all[i], all[j]), 0.75) << i << " and " << j;
    }
    EXPECT_EQ(all, distractors(300, 200));
}

TEST(Lineup, KnowsItsImageAtAnySize) {
    for (const int side : {128, 300, 512}) {
        const Mask target =
            joined(box(side, side, side / 4, side / 4, side / 2, side / 3),
                   box(side, side, side / 3, side / 3, side / 2, 3 * side / 4));
        const Lineup lineup(target);
        EXPECT_GT(lineup.standing_out(target), 10.0) << side;
        EXPECT_LT(lineup.standing_out(inverted(target)), -10.0) << side;
        EXPECT_LT(lineup.standing_out(distractors(side, side)[0]), 2.0) << side;
        EXPECT_EQ(lineup.standing_out(Mask(side, side)), 0.0);
        const Mask natural =
            Caster(fractal(side, side, 60.0f, 7), 1.0).shadow(sun_at(300.0, 15.0), 1);
        EXPECT_LT(std::abs(lineup.standing_out(natural)), 3.0) << side;
        EXPECT_THROW(lineup.standing_out(Mask(side, side + 1)), Error);
    }
}

ShadowImage own_shadow(const CheckedLand& land) {
    ShadowImage image{"hill", {}, sun_at(300.0, 20.0)};
    image.target = land.caster.shadow(image.sun, 1);
    return image;
}

TEST(Figures, OfTheLandsOwnShadow) {
    const CheckedLand land(fractal(96, 96, 60.0f, 5), 1.0);
    const ShadowImage image = own_shadow(land);
    const ShadowFigures figures = shadow_figures(land, &land, image);
    EXPECT_EQ(figures.iou_1x1, 1.0);
    EXPECT_GT(figures.fine.iou, 0.8);
    EXPECT_EQ(figures.fine.iou, figures.iou_frame);
    EXPECT_GT(figures.outline, 0.9);
    EXPECT_GT(figures.standing_out, 10.0);
    EXPECT_EQ(figures.relaxed.share, 0.0);
    EXPECT_EQ(figures.relaxed.bound, 1.0);
    ASSERT_EQ(figures.other_suns.size(), 10u);
    // What the base has itself is no trace of the image.
    for (const OtherSun& other : figures.other_suns) EXPECT_EQ(other.correlation(), 0.0);
    EXPECT_EQ(hiddenness(figures, 30.0), 0.0);
    EXPECT_EQ(outline_ratio(figures), outline_ratio_of_base(figures));
    EXPECT_EQ(figures.land.kurtosis, figures.base->kurtosis);
}

TEST(Figures, WithoutABaseNothingIsTakenOff) {
    const CheckedLand land(fractal(96, 96, 60.0f, 5), 1.0);
    const ShadowFigures figures = shadow_figures(land, nullptr, own_shadow(land));
    EXPECT_FALSE(figures.base.has_value());
    EXPECT_GT(hiddenness(figures, 10.0), 0.5);
    EXPECT_GT(hiddenness(figures, 10.0), hiddenness(figures, 30.0));
    EXPECT_GT(hiddenness(figures, 30.0), hiddenness(figures, 90.0));
    EXPECT_LT(hiddenness(figures, 180.0), 0.1);
}

TEST(Figures, ABrightImageIsNotHidden) {
    ShadowFigures figures;
    figures.other_suns = {{{}, radians(90.0), {-0.4, 1.0, -5.0}, Trace{0.1, 1.0, 0.0}},
                          {{}, radians(-90.0), {0.3, 1.0, 4.0}, Trace{0.1, 1.0, 0.0}}};
    EXPECT_DOUBLE_EQ(hiddenness(figures, 90.0), 0.35);
    EXPECT_DOUBLE_EQ(worst_standing_out(figures), 5.0);
}

TEST(Figures, TurnedSunsAreWhatTheySay) {
    const CheckedLand land(fractal(48, 48, 20.0f, 5), 1.0);
    ShadowImage image{"x", box(48, 48, 10, 10, 30, 30), sun_at(40.0, 25.0)};
    const auto figures = shadow_figures(land, nullptr, image);
    for (const OtherSun& other : figures.other_suns) {
        const bool raised = other.turned == 0.0;
        EXPECT_NEAR(degrees(other.sun.elevation), raised ? 45.0 : 25.0, 1e-9);
        EXPECT_NEAR(other.sun.azimuth - image.sun.azimuth, other.turned, 1e-9);
        EXPECT_EQ(other.land.correlation,
                  correlation(land.caster.shadow(other.sun, 1), image.target));
    }
    image.sun = sun_at(40.0, 60.0);  // already above 45
    EXPECT_NEAR(
        degrees(shadow_figures(land, nullptr, image).other_suns.back().sun.elevation),
        80.0, 1e-9);
}

TEST(Figures, GivenUpCellsBoundTheIoU) {
    ShadowImage image{"x", box(20, 20, 0, 0, 10, 10), sun_at(0.0, 25.0)};
    EXPECT_EQ(relaxed(image).bound, 1.0);
    image.relaxed = joined(box(20, 20, 0, 0, 2, 10), box(20, 20, 15, 0, 20, 4));
    // 20 of 100 are missed, 20 are spurious.
    EXPECT_DOUBLE_EQ(relaxed(image).bound, 80.0 / 120.0);
    EXPECT_DOUBLE_EQ(relaxed(image).share, 40.0 / 400.0);
    image.window = box(20, 20, 0, 0, 10, 20);
    EXPECT_DOUBLE_EQ(relaxed(image).bound, 80.0 / 100.0);
    EXPECT_DOUBLE_EQ(relaxed(image).share, 20.0 / 200.0);
}

TEST(Figures, ShapesThatDoNotFitAreRefused) {
    const CheckedLand land(fractal(48, 48, 20.0f, 5), 1.0);
    const CheckedLand other(fractal(40, 48, 20.0f, 5), 1.0);
    ShadowImage image{"x", Mask(48, 48), sun_at(0.0, 25.0)};
    EXPECT_THROW(shadow_figures(land, &other, image), Error);
    EXPECT_THROW(shadow_figures(other, nullptr, image), Error);
    image.window = Mask(48, 40);
    EXPECT_THROW(shadow_figures(land, nullptr, image), Error);
}

TEST(Figures, OfAnEmptyImage) {
    const CheckedLand land(Field<float>(32, 32), 1.0);
    const ShadowImage image{"x", Mask(32, 32), sun_at(0.0, 25.0)};
    const auto figures = shadow_figures(land, &land, image);
    EXPECT_EQ(figures.fine.iou, 1.0);
    EXPECT_EQ(figures.outline, 1.0);
    EXPECT_EQ(figures.standing_out, 0.0);
    EXPECT_EQ(figures.thin_recall, std::nullopt);
}

double between(const Sun& a, const Sun& b) {
    const Vec3 p = direction_to(a), q = direction_to(b);
    return degrees(std::acos(std::clamp(p.x * q.x + p.y * q.y + p.z * q.z, -1.0, 1.0)));
}

TEST(SunClock, GoesFromEastToWestThroughItsOwnSun) {
    for (const double azimuth : {0.0, 55.0, 90.0, 91.0, 180.0, 215.0, 270.0, 359.0})
        for (const double elevation : {1.0, 8.0, 25.0, 60.0, 88.0}) {
            const Sun own = sun_at(azimuth, elevation);
            const ClockSuns clock = clock_suns(own);
            EXPECT_EQ(clock.suns[static_cast<std::size_t>(clock.own)], own);
            EXPECT_GT(std::sin(clock.suns.front().azimuth), 0.0) << azimuth;
            EXPECT_LT(std::sin(clock.suns.back().azimuth), 0.0) << azimuth;
            for (std::size_t i = 0; i < clock.suns.size(); ++i) {
                EXPECT_GT(degrees(clock.suns[i].elevation), 0.9);
                // Nearer where a sun at the horizon was lifted off it.
                if (i > 0) {
                    EXPECT_NEAR(between(clock.suns[i], clock.suns[i - 1]), 15.0, 2.1)
                        << azimuth << " " << elevation << " " << i;
                }
            }
        }
}

TEST(SunClock, ShowsEverySun) {
    const CheckedLand land(fractal(60, 40, 20.0f, 5), 1.0);
    const Field<Rgb8> clock = sun_clock(land, sun_at(120.0, 25.0));
    EXPECT_GT(clock.width(), 1280);
    EXPECT_GT(clock.height(), 640);
    std::set<std::array<std::uint8_t, 3>> colours(clock.begin(), clock.end());
    EXPECT_GT(colours.size(), 500u);
    EXPECT_EQ(colours.count({255, 190, 40}), 1u);  // the frame of its own sun
}

}  // namespace
}  // namespace cydonia::render
