// Depth of field as POV-Ray draws it.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>

#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "render/frames/povray.h"
#include "render/pov/scene.h"
#include "tests/field/temporary_folder.h"
#include "tests/render/no_povray.h"

namespace cydonia::render {
namespace {

namespace fs = std::filesystem;

constexpr double kFocus = 1000.0;    // metres
constexpr double kAperture = 100.0;  // metres
constexpr int kSide = 256;

class DrawnLens : public testing::Test {
  protected:
    void SetUp() override {
        if (const auto missing = no_povray()) GTEST_SKIP() << *missing;
        shot.name = "lens";
        shot.camera.eye = {640.0, -900.0, 3000.0};
        shot.camera.target = {640.0, 600.0, 3000.0};
        shot.camera.field_of_view = radians(30.0);
        shot.camera.width = shot.camera.height = kSide;
        shot.camera.aperture = kAperture;
        shot.camera.focus_distance = kFocus;
        shot.quality = Quality::kPreview;
    }

    // A small light on the view's axis, nothing else; through the camera of the scene.
    Field<Rgb> light_at(double distance, int threads = 2) {
        const Field<float> flat(64, 64, 0.0f);
        std::string text = pov_scene(shot, quantised(flat), 20.0);
        text.resize(text.find("#declare ToSun"));
        text += fmt::format(
            "sphere {{ At(640, {}, 3000), {} / Unit pigment {{ rgb 1 }}\n"
            "finish {{ diffuse 0 emission 1000 }} }}\n",
            -900.0 + distance, 0.004 * distance);
        write_text(folder / "lens.pov", text);
        write_text(folder / "lens.ini",
                   fmt::format("Input_File_Name=lens.pov\nOutput_File_Name=lens.exr\n"
                               "Output_File_Type=E\nWidth={0}\nHeight={0}\n",
                               kSide));
        SilentProgress progress;
        run_povray(folder.path(), "lens", threads, std::chrono::minutes(2), progress);
        return read_exr_rgb(folder / "lens.exr");
    }

    Shot shot;
    TemporaryFolder folder;
};

// Of the light, pixels: the root of the mean of its squared distances from its middle.
double spread(const Field<Rgb>& frame) {
    double sum = 0.0, x = 0.0, y = 0.0, squares = 0.0;
    for (int j = 0; j < frame.height(); ++j)
        for (int i = 0; i < frame.width(); ++i) {
            const double light = frame(i, j)[1];
            sum += light, x += light * i, y += light * j;
            squares += light * (i * i + j * j);
        }
    x /= sum, y /= sum;
    return std::sqrt(squares / sum - x * x - y * y);
}

// A point at s is drawn as a disc, on the plane in focus at F, of D |F - s| / s; the
// spread of an even disc is its diameter over the root of eight.
double spread_of_disc(double s) {
    const double disc = kAperture * std::abs(kFocus - s) / s;
    const double plane = 2.0 * kFocus * std::tan(radians(15.0));
    return disc / plane * kSide / std::sqrt(8.0);
}

TEST_F(DrawnLens, WhatIsInFocusIsSharp) { EXPECT_LT(spread(light_at(kFocus)), 1.5); }

TEST_F(DrawnLens, DiscsAreAsWideAsOpticsSays) {
    for (const double distance : {500.0, 700.0, 2500.0})
        EXPECT_NEAR(spread(light_at(distance)) / spread_of_disc(distance), 1.0, 0.08)
            << distance;
}

TEST_F(DrawnLens, IsEqualWithOneThreadAndFour) {
    EXPECT_EQ(light_at(700.0, 1), light_at(700.0, 4));
}

TEST_F(DrawnLens, APinholeDrawsAllSharp) {
    shot.camera.aperture = 0.0;
    EXPECT_LT(spread(light_at(500.0)), 1.5);
}

}  // namespace
}  // namespace cydonia::render
