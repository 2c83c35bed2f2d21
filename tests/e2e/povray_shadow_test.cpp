// POV-Ray's own shadow against the caster's: the diagonal of the squares, the handedness,
// the scale and the direction to the sun are the same, or the check proves nothing about
// the frames. The scene is the test's own, as plain as POV-Ray allows.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

#include <filesystem>
#include <string>

#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "field/quantise.h"
#include "render/shadow/check.h"
#include "tests/render/shadow_land.h"

extern char** environ;

namespace cydonia::render {
namespace {

namespace fs = std::filesystem;

constexpr int kSide = 256;
constexpr double kSpacing = 20.0;

// Overhead, north up, one pixel a sample; white ground that shows nothing but the sun. In
// POV-Ray x is east, y up and z north.
std::string scene(const Heights16& heights, const Sun& sun) {
    const double extent = kSide * kSpacing, middle = 0.5 * extent;
    const Vec3 light = Vec3{middle, middle, 0.0} + 1000.0 * extent * direction_to(sun);
    return fmt::format(
        R"(#version 3.7;
global_settings {{ assumed_gamma 1.0 ambient_light 0 }}
camera {{
    orthographic location <{0}, {1}, {0}>
    direction -y right {2} * x up {2} * z
}}
light_source {{ <{3}, {4}, {5}> color rgb 1 parallel point_at <{0}, 0, {0}> }}
height_field {{
    png "heights.png" gamma 1.0
    scale <{6}, {7}, {6}> translate <{8}, {9}, {8}>
    pigment {{ color rgb 1 }} finish {{ ambient 0 diffuse 1 }}
}}
)",
        middle, heights.base + heights.range + extent, extent, light.x, light.z, light.y,
        (kSide - 1) * kSpacing, heights.range, 0.5 * kSpacing, heights.base);
}

// Runs `povray` of the PATH in `folder`; its words go to povray.log. 127: there is none.
int run_povray(const fs::path& folder) {
    const std::string size = std::to_string(kSide * kCheckRays);
    std::string arguments[] = {"povray", "+Iscene.pov", "+Oframe.exr", "+FE",
                               "-D",     "-A",          "+W" + size,   "+H" + size};
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, 1, "povray.log",
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    pid_t child = 0;
    const int error =
        posix_spawnp(&child, "povray", &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) return 127;
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

// Without the outermost samples, where POV-Ray has no mesh.
Mask inner(const Mask& mask) {
    Mask result(mask.width() - 2, mask.height() - 2);
    for (int y = 0; y < result.height(); ++y)
        for (int x = 0; x < result.width(); ++x) result(x, y) = mask(x + 1, y + 1);
    return result;
}

// Dark where no sun arrives.
Mask dark_pixels(const Field<Rgb>& frame) {
    Mask result(frame.width(), frame.height());
    for (std::size_t i = 0; i < frame.size(); ++i) result[i] = frame[i][1] < 1e-3f;
    return result;
}

Mask black_pixels(const Field<Rgba8>& picture) {
    Mask result(picture.width(), picture.height());
    for (std::size_t i = 0; i < picture.size(); ++i) result[i] = picture[i][0] < 128;
    return result;
}

class PovrayShadow : public testing::TestWithParam<Sun> {
  protected:
    PovrayShadow()
        : folder_(fs::temp_directory_path() /
                  fmt::format("cydonia_povray_{}_{}", getpid(),
                              std::lround(degrees(GetParam().elevation)))) {
        fs::create_directories(folder_);
    }
    ~PovrayShadow() override { fs::remove_all(folder_); }

    fs::path folder_;
};

TEST_P(PovrayShadow, IsTheCastersShadow) {
    Terrain terrain;
    terrain.spacing = kSpacing;
    terrain.heights = fractal(kSide, kSide, 350.0f, 11);
    terrain.shadows = {{"land", Mask(kSide, kSide), GetParam(), 0.0}};
    const Heights16 heights = quantised(terrain.heights);
    write_png(folder_ / "heights.png", heights.levels);
    write_text(folder_ / "scene.pov", scene(heights, GetParam()));
    const int exit_code = run_povray(folder_);
    if (exit_code == 127) GTEST_SKIP() << "no povray on the PATH";
    ASSERT_EQ(exit_code, 0) << read_text(folder_ / "povray.log");

    check(terrain, folder_);
    const Mask cast = inner(black_pixels(read_rgba(open_source(folder_ / "cast.png"))));
    const Mask drawn = inner(dark_pixels(read_exr_rgb(folder_ / "frame.exr")));
    const double iou = score(cast, drawn).iou;
    const double dark =
        static_cast<double>(area(cast)) / static_cast<double>(cast.size());
    EXPECT_GE(iou, 0.995);
    EXPECT_GT(dark, 0.03);
    EXPECT_LT(dark, 0.97);
    RecordProperty("iou", fmt::format("{:.5f}", iou));
    RecordProperty("dark", fmt::format("{:.3f}", dark));
    fmt::print("IoU {:.5f} of POV-Ray's shadow and cast.png, {:.1f}% dark\n", iou,
               100.0 * dark);
}

INSTANTIATE_TEST_SUITE_P(Elevations, PovrayShadow,
                         testing::Values(sun_at(300.0, 15.0), sun_at(55.0, 25.0),
                                         sun_at(215.0, 45.0)),
                         [](const auto& suite) {
                             return std::to_string(
                                 std::lround(degrees(suite.param.elevation)));
                         });

}  // namespace
}  // namespace cydonia::render
