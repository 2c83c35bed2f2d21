// Turntables and films through the program that was built.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "field/image.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"
#include "tests/render/no_povray.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

const std::string kOrbit = R"([[render.camera]]
name = "orbit"
kind = "orbit"
elevation = 40.0
size = [288, 162]
)";

const std::string kFlight = R"([[render.camera]]
name = "flight"
kind = "path"
size = [288, 162]
[[render.camera.key]]
frame = 0
eye = [640.0, 100.0, 300.0]
target = [640.0, 700.0, 0.0]
[[render.camera.key]]
frame = 3
eye = [640.0, 300.0, 300.0]
target = [640.0, 900.0, 0.0]
)";

std::string land_with(const std::string& cameras, const std::string& render = "") {
    return kSmallScene.substr(0, kSmallScene.find("[[render.camera]]")) + "[render]\n" +
           render + cameras;
}

struct Sequences : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/land";

    Outcome ask(const std::string& command, const std::string& scene,
                std::vector<std::string> more = {},
                const std::string& quality = "draft") {
        folder.write("land.toml", scene);
        std::vector<std::string> arguments{command, "land.toml", "--quality",
                                           quality, "--set",     "terrain.samples=32"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run({folder.path()}, arguments);
    }
    Field<Rgba8> picture(const std::string& name) const {
        return read_rgba(open_source(out / "frames" / name));
    }
    Field<Rgb> light(const std::string& name) const {
        return read_exr_rgb(out / "frames" / name);
    }
    std::map<std::string, fs::file_time_type> times() const {
        std::map<std::string, fs::file_time_type> times;
        for (const std::string& file : files_below(out / "frames"))
            times[file] = fs::last_write_time(out / "frames" / file);
        return times;
    }
    std::string exposure(const std::string& name) const {
        const auto in = OIIO::ImageInput::open((out / "frames" / name).string());
        return in->spec().get_string_attribute("cydonia:exposure");
    }
};

double difference(const Field<Rgb>& a, const Field<Rgb>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(static_cast<double>(a[i][c]) - b[i][c]) /
                                      std::max(0.05, static_cast<double>(a[i][c])));
    return most;
}

}  // namespace

TEST_F(Sequences, ALookAtATurntableNeedsNoPovray) {
    const Outcome outcome =
        ask("turntable", kSmallScene,
            {"--engine", "embree", "--size", "97x55", "--frames", "5"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* file : {"turntable-natural-0001.png", "turntable-natural-0005.png",
                             "turntable-natural.mp4", "turntable-natural.webp",
                             "turntable-natural.gif", "turntable-natural.jpg"})
        EXPECT_GT(fs::file_size(out / "frames" / file), 0u) << file;
    const Field<Rgba8> first = picture("turntable-natural-0001.png");
    EXPECT_EQ(first.width(), 97);
    EXPECT_EQ(first.height(), 55);
    EXPECT_NE(first, picture("turntable-natural-0002.png"));
    EXPECT_FALSE(fs::exists(out / "pov"));

    const auto before = times();
    fs::remove(out / "frames/turntable-natural-0003.png");
    ASSERT_EQ(ask("turntable", kSmallScene,
                  {"--engine", "embree", "--size", "97x55", "--frames", "5"})
                  .code,
              0);
    EXPECT_EQ(times().at("turntable-natural-0002.png"),
              before.at("turntable-natural-0002.png"));
    EXPECT_NE(times().at("turntable-natural-0003.png"),
              before.at("turntable-natural-0003.png"));
}

// Light of the sky, noise and exposure stand still: what does not change is equal.
TEST_F(Sequences, WhatDoesNotMoveDoesNotFlicker) {
    if (const auto why = no_povray()) GTEST_SKIP() << *why;
    const std::string scene = land_with(
        kOrbit,
        "sun = { azimuth = 225.0, elevation = { keys = [[0, 30.0], [2, 30.0]] } }\n");
    const Outcome outcome = ask("film", scene, {"--size", "64x36"}, "preview");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(picture("film-0001.png"), picture("film-0002.png"));
    EXPECT_EQ(picture("film-0001.png"), picture("film-0003.png"));
}

TEST_F(Sequences, AFlightMovesAndHasMotionVectors) {
    if (const auto why = no_povray()) GTEST_SKIP() << *why;
    const std::string scene = land_with(kFlight, "passes = { which = [\"motion\"] }\n");
    const Outcome outcome = ask("film", scene);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(fs::exists(out / "frames/film-0005.png"));
    EXPECT_GT(difference(light("film-0001.exr"), light("film-0003.exr")), 0.2);
    EXPECT_EQ(exposure("film-0001.exr"), exposure("film-0004.exr"));

    const auto in =
        OIIO::ImageInput::open((out / "frames/film-0002.passes.exr").string());
    ASSERT_TRUE(in->seek_subimage(1, 0));
    const OIIO::ImageSpec spec = in->spec();
    EXPECT_EQ(spec.channelnames, (std::vector<std::string>{"motion.X", "motion.Y"}));
    std::vector<float> motion(static_cast<std::size_t>(spec.width * spec.height * 2));
    ASSERT_TRUE(in->read_image(1, 0, 0, 2, OIIO::TypeFloat, motion.data()));
    // Forward: land near the frame's foot goes down, and to both sides.
    const auto at = [&](int x, int y) { return &motion[2u * (y * spec.width + x)]; };
    const int foot = spec.height - 2;
    EXPECT_GT(at(spec.width / 2, foot)[1], 1.0f);
    EXPECT_LT(at(4, foot)[0], -0.5f);
    EXPECT_GT(at(spec.width - 5, foot)[0], 0.5f);
}

// A shutter blurs what moves; what stands still stays as it is.
TEST_F(Sequences, AShutterBlursTheFlight) {
    if (const auto why = no_povray()) GTEST_SKIP() << *why;
    const auto blurred = [&](const std::string& scene) {
        EXPECT_EQ(ask("film", scene, {"--frames", "2"}).code, 0);
        return light("film-0002.exr");
    };
    const Field<Rgb> sharp = blurred(land_with(kFlight));
    std::string open = kFlight;
    open.insert(open.find("[[render.camera.key]]"),
                "shutter_angle = 360.0\nshutter_samples = 5\n");
    EXPECT_GT(difference(sharp, blurred(land_with(open))), 0.1);
    EXPECT_FALSE(fs::exists(out / "pov/film-0002.s001.exr")) << "moments are not kept";

    const std::string still =
        "sun = { azimuth = 225.0, elevation = { keys = [[0, 30.0]] } }\n";
    const Field<Rgb> one = blurred(land_with(kOrbit, still));
    const Field<Rgb> five = blurred(land_with(kOrbit + "shutter_samples = 5\n", still));
    EXPECT_LT(difference(one, five), 2e-3);
}

// The land is made anew for every frame, its files are not kept, nothing is made twice.
TEST_F(Sequences, LandThatRises) {
    if (const auto why = no_povray()) GTEST_SKIP() << *why;
    std::string scene = land_with(kOrbit);
    scene.insert(scene.find("[[terrain.stage.group]]"),
                 "vertical_scale = { keys = [[0, 0.1], [2, 1.0]] }\n");
    const Outcome outcome = ask("film", scene);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_GT(difference(light("film-0001.exr"), light("film-0003.exr")), 0.2);
    for (const auto& entry : fs::directory_iterator(out / "pov"))
        EXPECT_FALSE(entry.is_directory()) << entry.path();

    // The last frame is what a still of that land would be.
    std::string grown = scene;
    const std::string keys = "{ keys = [[0, 0.1], [2, 1.0]] }";
    grown.replace(grown.find(keys), keys.size(), "1.0");
    const Field<Rgb> last = light("film-0003.exr");
    ASSERT_EQ(ask("render", grown).code, 0);
    EXPECT_EQ(light("orbit.exr"), last);

    const auto before = times();
    const Outcome again = ask("film", scene);
    EXPECT_EQ(again.code, 0);
    EXPECT_EQ(times().at("film-0002.png"), before.at("film-0002.png"));
}

TEST_F(Sequences, TheFolderOfAnotherSceneIsRefused) {
    const std::vector<std::string> look{"--engine", "embree",   "--size",
                                        "32x18",    "--frames", "1"};
    ASSERT_EQ(ask("turntable", kSmallScene, look).code, 0);
    folder.write("other.toml", kSmallScene);
    const Outcome outcome =
        run({folder.path()}, {"synth", "other.toml", "-o", out.string()});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("holds the scene 'land'; name another folder with -o"),
              std::string::npos)
        << outcome.err;
}

TEST_F(Sequences, BadInput) {
    const auto expect_refused = [&](const std::string& command, const std::string& scene,
                                    const std::string& words,
                                    const std::vector<std::string>& more = {}) {
        const Outcome outcome = ask(command, scene, more);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(out / "frames"));
    };
    expect_refused("film", kSmallScene, "nothing to film");
    expect_refused("turntable", kSmallScene, "--frames", {"--frames", "0"});
    expect_refused("turntable", kSmallScene, "640x360", {"--size", "640"});
    expect_refused("turntable", kSmallScene, "640x360", {"--size", "8x99999"});
    std::string swapped = kFlight;
    swapped.replace(swapped.find("frame = 3"), 9, "frame = -3");
    expect_refused("film", land_with(swapped), "stands after the one at");
    // Down to the ground on the way around.
    expect_refused("turntable", land_with(kOrbit + "distance = 300.0\nelevation = 2.0\n"),
                   "elevation");
}
