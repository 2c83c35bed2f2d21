#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/colour/colour.h"
#include "render/frames/frame.h"
#include "tests/field/temporary_folder.h"
#include "tests/render/environment.h"

namespace cydonia::render {
namespace {

class Frames : public testing::Test {
  protected:
    void deliver(const Field<Rgb>& rec709, const ColourOptions& colour = {}) {
        write_exr(folder / "traced.exr", rec709);
        deliver_frame(folder / "traced.exr", folder.path(), "frame", colour,
                      {{"cydonia:seed", "7"}});
    }
    Field<Rgb> exr() const { return read_exr_rgb(folder / "frame.exr"); }
    Field<Rgba8> png() const { return read_rgba(open_source(folder / "frame.png")); }

    TemporaryFolder folder;
    Environment no_ocio{"OCIO", nullptr};
};

// A dark and a light half, as land in shadow and in the sun.
Field<Rgb> land(float light) {
    Field<Rgb> picture(20, 10, {0.1f * light, 0.1f * light, 0.1f * light});
    for (int y = 0; y < 10; ++y)
        for (int x = 10; x < 20; ++x)
            picture(x, y) = {0.5f * light, 0.4f * light, 0.3f * light};
    return picture;
}

Rgb8 shown_as_bytes(const Rgb& acescg) {
    return Display({}).shown(Field<Rgb>(1, 1, acescg))(0, 0);
}

TEST_F(Frames, ExrIsUngradedAcesCgAndKeepsNegatives) {
    Field<Rgb> picture = land(1.0f);
    picture(3, 2) = {-0.5f, 0.25f, -0.125f};
    ColourOptions bright;
    bright.exposure = 3.0;
    deliver(picture, bright);

    const Field<Rgb> delivered = exr();
    ASSERT_TRUE(delivered.same_shape(picture));
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const Rgb truth = acescg_from_rec709(picture[i]);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(delivered[i][c], truth[c], 1e-3 * std::abs(truth[c])) << i;
    }
    EXPECT_LT(delivered(3, 2)[0], 0.0f);
}

TEST_F(Frames, ExrSaysWhatItIs) {
    deliver(land(1.0f));
    const auto input = OIIO::ImageInput::open((folder / "frame.exr").string());
    ASSERT_TRUE(input);
    const OIIO::ImageSpec& spec = input->spec();
    EXPECT_EQ(spec.format, OIIO::TypeHalf);
    float primaries[8] = {};
    ASSERT_TRUE(spec.getattribute("chromaticities",
                                  OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), primaries));
    const float aces_cg[8] = {0.713f, 0.293f, 0.165f,   0.83f,
                              0.128f, 0.044f, 0.32168f, 0.33767f};
    for (int i = 0; i < 8; ++i) EXPECT_FLOAT_EQ(primaries[i], aces_cg[i]);
    EXPECT_EQ(spec.get_string_attribute("cydonia:seed"), "7");
    EXPECT_EQ(spec.get_string_attribute("cydonia:display"), "sRGB");
    EXPECT_EQ(spec.get_string_attribute("cydonia:view"), "ACES 1.0 - SDR Video");
    EXPECT_NE(spec.get_string_attribute("cydonia:exposure"), "");
}

TEST_F(Frames, StrayRaysAreScrubbed) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInf = std::numeric_limits<float>::infinity();
    Field<Rgb> picture = land(1.0f);
    picture(0, 0) = {kNan, kInf, -kInf};
    picture(1, 0) = {kNan, kNan, kNan};
    deliver(picture);
    for (const Rgb& pixel : exr())
        for (float value : pixel) EXPECT_TRUE(std::isfinite(value));
    EXPECT_EQ(exr()(1, 0), (Rgb{0, 0, 0}));
    EXPECT_EQ(png()(15, 5), (deliver(land(1.0f)), png()(15, 5)));
}

// Middle grey is the pivot of the grade: only exposure and the view move it.
TEST_F(Frames, NinetiethPercentileStandsAtHalf) {
    ColourOptions colour;
    colour.exposure = std::log2(0.18 / 0.5);
    deliver(Field<Rgb>(8, 8, {3.0f, 3.0f, 3.0f}), colour);
    const Rgb8 grey = shown_as_bytes({0.18f, 0.18f, 0.18f});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(png()(4, 4)[c], grey[c], 1);
}

TEST_F(Frames, ExposureFollowsTheLight) {
    deliver(land(1.0f));
    const Field<Rgba8> day = png();
    deliver(land(0.25f));
    EXPECT_EQ(png(), day);
    const Field<Rgb> dusk = exr();
    EXPECT_NEAR(dusk(15, 5)[0] / dusk(5, 5)[0], 4.6, 0.1);
}

TEST_F(Frames, OneStopIsTwiceTheLight) {
    Field<Rgb> picture = land(1.0f);
    ColourOptions up;
    up.exposure = 1.0;
    deliver(picture, up);
    const Field<Rgba8> brighter = png();
    deliver(picture);
    EXPECT_GT(brighter(5, 5)[1], png()(5, 5)[1] + 10);
}

TEST_F(Frames, GlintsDoNotDarkenTheLand) {
    Field<Rgb> picture = land(1.0f);
    deliver(picture);
    const Rgba8 before = png()(15, 5);
    for (int x = 0; x < 10; ++x) picture(x, 0) = {500.0f, 500.0f, 500.0f};
    deliver(picture);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(png()(15, 5)[c], before[c], 1);
}

// A quarter stands at 0.5 already, so the exposure is 0 EV.
TEST_F(Frames, GradeWidensContrastAboutMiddleGreyAndColour) {
    Field<Rgb> picture(8, 8, {0.02f, 0.02f, 0.02f});
    for (int y = 0; y < 2; ++y)
        for (Rgb& pixel : picture.row(y)) pixel = {0.5f, 0.5f, 0.5f};
    picture(0, 7) = {0.2f, 0.18f, 0.16f};
    deliver(picture);
    EXPECT_GT(png()(0, 0)[1], shown_as_bytes({0.5f, 0.5f, 0.5f})[1] + 3);
    EXPECT_LT(png()(0, 4)[1], shown_as_bytes({0.02f, 0.02f, 0.02f})[1] - 3);
    const Rgb8 plain = shown_as_bytes(acescg_from_rec709(picture(0, 7)));
    EXPECT_GT(png()(0, 7)[0] - png()(0, 7)[2], 1.2 * (plain[0] - plain[2]));
}

TEST_F(Frames, BlackStaysBlackAndFaintLightIsLiftedSixStopsAtMost) {
    deliver(Field<Rgb>(4, 4));
    EXPECT_EQ(png()(2, 2), (Rgba8{0, 0, 0, 255}));
    deliver(Field<Rgb>(4, 4, {1e-4f, 1e-4f, 1e-4f}));
    EXPECT_LT(png()(2, 2)[1], 20);
}

TEST_F(Frames, SamePictureSameBytes) {
    deliver(land(1.0f));
    const std::string exr_bytes = read_text(folder / "frame.exr");
    const std::string png_bytes = read_text(folder / "frame.png");
    deliver(land(1.0f));
    EXPECT_EQ(read_text(folder / "frame.exr"), exr_bytes);
    EXPECT_EQ(read_text(folder / "frame.png"), png_bytes);
}

TEST_F(Frames, UnknownViewLeavesNothing) {
    ColourOptions colour;
    colour.view = "Filmic";
    expect_error(ExitCode::kBadRequest, "'Filmic'", [&] { deliver(land(1.0f), colour); });
    EXPECT_FALSE(std::filesystem::exists(folder / "frame.exr"));
    EXPECT_FALSE(std::filesystem::exists(folder / "frame.png"));
}

TEST_F(Frames, TruncatedTraceLeavesNothing) {
    write_exr(folder / "traced.exr", land(1.0f));
    const std::string bytes = read_text(folder / "traced.exr");
    for (const std::size_t size : {bytes.size() / 2, bytes.size() - 8, std::size_t{0}}) {
        write_text(folder / "cut.exr", bytes.substr(0, size));
        expect_error(ExitCode::kBadRequest, "cut.exr", [&] {
            deliver_frame(folder / "cut.exr", folder.path(), "frame", {}, {});
        });
        EXPECT_FALSE(std::filesystem::exists(folder / "frame.exr"));
    }
}

TEST_F(Frames, FolderThatDoesNotExist) {
    write_exr(folder / "traced.exr", land(1.0f));
    expect_error(ExitCode::kFailed, "frame.exr", [&] {
        deliver_frame(folder / "traced.exr", folder / "nowhere", "frame", {}, {});
    });
}

}  // namespace
}  // namespace cydonia::render
