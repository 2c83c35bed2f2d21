#include "render/shadow/check.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "field/error.h"
#include "field/image.h"
#include "field/quantise.h"
#include "render/shadow/caster.h"
#include "tests/render/shadow_land.h"

namespace cydonia::render {
namespace {

namespace fs = std::filesystem;

// A folder of the test's own, gone with it.
class Check : public testing::Test {
  protected:
    Check()
        : folder_(fs::temp_directory_path() /
                  ("cydonia_check_" +
                   std::to_string(reinterpret_cast<std::uintptr_t>(this)) +
                   testing::UnitTest::GetInstance()->current_test_info()->name())) {
        fs::remove_all(folder_);
    }
    ~Check() override { fs::remove_all(folder_); }

    Field<Rgba8> picture(const fs::path& name) const {
        return read_rgba(open_source(folder_ / name));
    }

    fs::path folder_;
    SilentProgress progress_;
};

Terrain mountains() {
    Terrain terrain;
    terrain.heights = fractal(80, 60, 120.0f, 5);
    terrain.spacing = 10.0;
    return terrain;
}

// The terrain's own shadow at cell centres, moved east: nearly right, wrong both ways.
ShadowImage own_shadow(const Terrain& terrain, const std::string& name, int moved) {
    const Sun sun = sun_at(300.0, 20.0);
    const Mask cast = Caster(terrain.heights, terrain.spacing).shadow(sun, 1);
    Mask target(cast.width(), cast.height());
    for (int y = 0; y < cast.height(); ++y)
        for (int x = moved; x < cast.width(); ++x) target(x, y) = cast(x - moved, y);
    return {name, target, sun, 0.85};
}

TEST(Score, OneWhereCastIsTarget) {
    const Mask mask = own_shadow(mountains(), "", 0).target;
    const ShadowScore s = score(mask, mask);
    EXPECT_EQ(s.iou, 1.0);
    EXPECT_EQ(s.precision, 1.0);
    EXPECT_EQ(s.recall, 1.0);
}

TEST(Score, CountsSamples) {
    Mask cast(4, 4), target(2, 2);  // 2x2 rays a cell
    target(0, 0) = target(1, 0) = 1;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y) cast(x, y) = 1;
    const ShadowScore s = score(cast, target);  // hit 6, cast 9, target 8
    EXPECT_DOUBLE_EQ(s.iou, 6.0 / 11.0);
    EXPECT_DOUBLE_EQ(s.precision, 6.0 / 9.0);
    EXPECT_DOUBLE_EQ(s.recall, 6.0 / 8.0);
    EXPECT_DOUBLE_EQ(1.0 / s.iou, 1.0 / s.precision + 1.0 / s.recall - 1.0);
}

TEST(Score, EmptyAndFullMasks) {
    const Mask lit(6, 6, 0), dark(6, 6, 1);
    EXPECT_EQ(score(lit, lit).iou, 1.0);
    EXPECT_EQ(score(dark, dark).iou, 1.0);
    EXPECT_EQ(score(lit, dark).iou, 0.0);
    EXPECT_EQ(score(lit, dark).recall, 0.0);
    EXPECT_EQ(score(dark, lit).iou, 0.0);
    EXPECT_EQ(score(dark, lit).precision, 0.0);
}

TEST(Score, ShapesThatDoNotFitAreRefused) {
    EXPECT_THROW(score(Mask(4, 4), Mask(3, 4)), Error);
    EXPECT_THROW(score(Mask(4, 8), Mask(4, 4)), Error);
    EXPECT_THROW(score(Mask(2, 2), Mask(4, 4)), Error);
    EXPECT_THROW(score(Mask(), Mask()), Error);
}

TEST_F(Check, ScoresTheRoundedHeightsAndWritesPictures) {
    Terrain terrain = mountains();
    terrain.shadows = {own_shadow(terrain, "hill", 1)};
    const auto reports = check(terrain, folder_);
    ASSERT_EQ(reports.size(), 1u);
    const Field<float> rounded = heights_of(quantised(terrain.heights));
    const Mask cast =
        Caster(rounded, terrain.spacing).shadow(terrain.shadows[0].sun, kCheckRays);
    EXPECT_EQ(reports[0].score.iou, score(cast, terrain.shadows[0].target).iou);
    EXPECT_GT(reports[0].score.iou, 0.4);
    EXPECT_LT(reports[0].score.iou, 0.9);

    const auto drawn = picture("cast.png"), wanted = picture("target.png");
    ASSERT_EQ(drawn.width(), 160);
    ASSERT_EQ(drawn.height(), 120);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
            ASSERT_EQ(drawn(x, y)[0], cast(x, y) ? 0 : 255);
            ASSERT_EQ(wanted(x, y)[0], terrain.shadows[0].target(x / 2, y / 2) ? 0 : 255);
        }
}

TEST_F(Check, SeveralImagesHaveFoldersOfTheirOwn) {
    Terrain terrain = mountains();
    terrain.shadows = {own_shadow(terrain, "one", 0), own_shadow(terrain, "two", 3)};
    EXPECT_EQ(check(terrain, folder_).size(), 2u);
    for (const char* name : {"one", "two"})
        for (const char* file : {"cast.png", "target.png", "overlay.png"})
            EXPECT_TRUE(fs::exists(folder_ / name / file)) << name << "/" << file;
}

TEST_F(Check, OnlyTheWindowCounts) {
    Terrain terrain = mountains();
    terrain.shadows = {own_shadow(terrain, "hill", 0)};
    ShadowImage& image = terrain.shadows[0];
    image.window = Mask(80, 60);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            image.window(x, y) = x < 40;
            if (x >= 40) image.target(x, y) = 0;
        }
    const double inside = check(terrain, folder_)[0].score.iou;
    EXPECT_GT(inside, 0.8);
    const auto window = picture("window.png");
    EXPECT_EQ(window(39, 20)[0], 255);
    EXPECT_EQ(window(40, 20)[0], 0);
    image.window = {};
    EXPECT_LT(check(terrain, folder_)[0].score.iou, 0.7 * inside);
}

TEST_F(Check, MeasuresBesideTheOtherPictures) {
    Terrain terrain = mountains();
    terrain.shadows = {own_shadow(terrain, "one", 0), own_shadow(terrain, "two", 3)};
    const auto reports = check(terrain, folder_);
    const auto figures = measure(terrain, &terrain.heights, folder_, progress_);
    ASSERT_EQ(figures.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(figures[i].fine.iou, reports[i].score.iou);
        EXPECT_TRUE(figures[i].base.has_value());
    }
    EXPECT_FALSE(measure(terrain, nullptr, folder_, progress_).front().base.has_value());
    for (const char* name : {"one", "two"})
        EXPECT_TRUE(fs::exists(folder_ / name / "sun-clock.png")) << name;
}

TEST_F(Check, NamesWhoContradicts) {
    Terrain terrain = mountains();
    terrain.shadows = {own_shadow(terrain, "one", 0), own_shadow(terrain, "two", 3),
                       own_shadow(terrain, "three", 5)};
    for (ShadowImage& image : terrain.shadows) image.window = Mask(80, 60);
    terrain.shadows[0].relaxed = Mask(80, 60);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 20; ++x) {
            terrain.shadows[0].window(x, y) = 1;
            terrain.shadows[0].relaxed(x, y) = x < 5;
            terrain.shadows[1].window(x, y) = x < 2;
            terrain.shadows[2].window(x, y) = x > 2;
        }
    const auto reports = check(terrain, folder_);
    EXPECT_DOUBLE_EQ(reports[0].relaxed, 0.25);
    EXPECT_EQ(reports[0].rival, "two");
    EXPECT_EQ(reports[1].relaxed, 0.0);
    EXPECT_EQ(reports[1].rival, "");
}

TEST_F(Check, NothingPromisedNothingWritten) {
    EXPECT_TRUE(check(mountains(), folder_).empty());
    EXPECT_TRUE(measure(mountains(), nullptr, folder_, progress_).empty());
    EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Check, BadTerrainIsRefused) {
    Terrain terrain = mountains();
    terrain.shadows = {own_shadow(terrain, "hill", 0)};
    terrain.heights(3, 3) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(check(terrain, folder_), Error);
    terrain = mountains();
    terrain.shadows = {{"hill", Mask(10, 10), sun_at(300.0, 20.0), 0.85}};
    EXPECT_THROW(check(terrain, folder_), Error);
    EXPECT_FALSE(fs::exists(folder_));
}

// CIELAB of an sRGB colour as a colour-blind reader sees it (Machado, Oliveira and
// Fernandes 2009, severity 1).
using Matrix = std::array<std::array<double, 3>, 3>;
constexpr std::array<Matrix, 3> kBlindness{{
    {{{0.152286, 1.052583, -0.204868},
      {0.114503, 0.786281, 0.099216},
      {-0.003882, -0.048116, 1.051998}}},  // protanopia
    {{{0.367322, 0.860646, -0.227968},
      {0.280085, 0.672501, 0.047413},
      {-0.011820, 0.042940, 0.968881}}},  // deuteranopia
    {{{1.255528, -0.076749, -0.178779},
      {-0.078411, 0.930809, 0.147602},
      {0.004733, 0.691367, 0.303900}}},  // tritanopia
}};
constexpr Matrix kXyzOverWhite{
    {{0.4339, 0.3762, 0.1899}, {0.2126, 0.7152, 0.0722}, {0.0177, 0.1095, 0.8728}}};

std::array<double, 3> product(const Matrix& m, const std::array<double, 3>& v) {
    std::array<double, 3> result{};
    for (int i = 0; i < 3; ++i)
        result[i] =
            std::clamp(m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2], 0.0, 1.0);
    return result;
}

std::array<double, 3> lab(Rgba8 colour, const Matrix& blindness) {
    std::array<double, 3> linear{};
    for (int i = 0; i < 3; ++i) {
        const double v = colour[i] / 255.0;
        linear[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    auto xyz = product(kXyzOverWhite, product(blindness, linear));
    for (double& t : xyz) t = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0;
    return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

TEST_F(Check, OverlayIsReadByTheColourBlind) {
    Terrain terrain;  // flat: one tone a kind
    terrain.heights = Field<float>(40, 40);
    for (int y = 0; y < 40; ++y) terrain.heights(20, y) = 5.0f;
    terrain.shadows = {own_shadow(terrain, "wall", 5)};
    Mask& relaxed = terrain.shadows[0].relaxed = Mask(40, 40);
    for (int x = 0; x < 40; ++x) relaxed(x, 35) = 1;
    check(terrain, folder_);
    const auto drawn = picture("overlay.png"), cast = picture("cast.png"),
               target = picture("target.png");
    const auto colour_of = [&](int in_cast, int in_target) {
        for (int x = 4; x < 76; ++x)
            if ((cast(x, 40)[0] == 0) == in_cast &&
                (target(x, 40)[0] == 0) == in_target && (x < 36 || x > 46))
                return drawn(x, 40);
        ADD_FAILURE() << "no such kind " << in_cast << in_target;
        return Rgba8{};
    };
    const std::array<Rgba8, 5> kinds{colour_of(0, 0), colour_of(1, 1), colour_of(1, 0),
                                     colour_of(0, 1), drawn(10, 70)};
    for (const Matrix& blindness : kBlindness)
        for (std::size_t a = 0; a < kinds.size(); ++a)
            for (std::size_t b = 0; b < a; ++b) {
                const auto p = lab(kinds[a], blindness), q = lab(kinds[b], blindness);
                EXPECT_GE(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 28.0)
                    << a << " and " << b;
            }
}

ShadowReport report_of(double iou, double precision, double recall) {
    return {"text", sun_at(55.0, 25.0), 0.85, {iou, precision, recall}};
}

TEST(Advice, NamesWhatFellShort) {
    EXPECT_EQ(advice(report_of(0.9, 0.95, 0.95)), "");
    const std::string low = advice(report_of(0.60, 0.99, 0.60));
    EXPECT_NE(low.find("IoU 0.600 (precision 0.990, recall 0.600); 0.850 is"),
              std::string::npos)
        << low;
    EXPECT_NE(low.find("40% of the target stays lit"), std::string::npos) << low;
    EXPECT_NE(low.find("Lower the sun"), std::string::npos) << low;
    EXPECT_EQ(low.find("Raise the sun"), std::string::npos) << low;
    const std::string spurious = advice(report_of(0.70, 0.72, 0.97));
    EXPECT_NE(spurious.find("28% of the shadow falls outside"), std::string::npos);
    EXPECT_NE(spurious.find("Raise the sun"), std::string::npos) << spurious;
    EXPECT_EQ(spurious.find("Lower the sun"), std::string::npos) << spurious;
}

TEST(Advice, SaysWhichImageToMove) {
    ShadowReport report = report_of(0.60, 0.99, 0.60);
    report.relaxed = 0.123;
    report.rival = "horse";
    const std::string text = advice(report);
    EXPECT_NE(text.find("12.3% of its window gave way to 'horse'"), std::string::npos)
        << text;
    EXPECT_NE(text.find("Move the two apart"), std::string::npos) << text;
    EXPECT_NE(text.find("violet"), std::string::npos) << text;
    report.score = {0.9, 0.95, 0.95};
    EXPECT_TRUE(report.passed());
    EXPECT_EQ(advice(report), "");
}

TEST(Advice, AnImageLostAmongOtherShadowsDoesNotRead) {
    ShadowReport report = report_of(0.95, 0.98, 0.97);
    report.standing_out = 3.5;
    EXPECT_TRUE(report.passed());
    report.standing_out = 2.0;
    EXPECT_FALSE(report.passed());
    EXPECT_NE(advice(report).find("lost among the land's own"), std::string::npos);
    report.min_iou = 0.0;  // nothing is asked
    EXPECT_TRUE(report.passed());
}

}  // namespace
}  // namespace cydonia::render
