// The whole road at a tiny size, through the program that was built and POV-Ray.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "field/image.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;
using Json = nlohmann::ordered_json;

namespace {

struct EndToEnd : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/land";
    EndToEnd() {
        folder.write("land.toml", kShadowScene);
        folder.write("bar.svg", kBar);
    }

    Outcome ask(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin() + 1, {"land.toml", "--quality", "draft"});
        return run({folder.path()}, arguments);
    }
    Json manifest() const {
        std::ifstream in(out / "manifest.json");
        return Json::parse(in);
    }
    std::map<std::string, fs::file_time_type> times() const {
        std::map<std::string, fs::file_time_type> times;
        for (const std::string& file : files_below(out)) {
            times[file] = fs::last_write_time(out / file);
        }
        std::erase_if(times,
                      [](const auto& t) { return t.first.starts_with(".cache/"); });
        return times;
    }
};

Json without_timings(Json manifest) {
    manifest.erase("timings");
    return manifest;
}

}  // namespace

// The demo that the README begins with, at a quarter of its samples.
TEST_F(EndToEnd, TheDemoSpellsItsWord) {
    const std::string scene = CYDONIA_SOURCE_DIR "/scenes/text/scene.toml";
    const fs::path demo = folder / "demo";
    const Outcome outcome =
        run({folder.path()},
            {"render", scene, "--quality", "draft", "-o", demo.string(), "--set",
             "terrain.samples=128", "--set", "terrain.stage[1].image[0].min_iou=0.85",
             "--set", "render.camera[0].size=[192, 192]", "--set",
             "render.camera[1].size=[192, 108]"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::ifstream in(demo / "manifest.json");
    EXPECT_GE(Json::parse(in)["figures"]["check"]["images"].at(0)["iou"], 0.85);
    // In the frame itself the word is dark: its first letter's bar against the ground
    // above.
    const Field<Rgb> frame = read_exr_rgb(demo / "frames/overhead.exr");
    ASSERT_EQ(frame.width(), 64);
    EXPECT_LT(frame(10, 24)[1], 0.5f * frame(10, 12)[1]);
    EXPECT_GT(fs::file_size(demo / "frames/oblique.png"), 0u);
}

TEST_F(EndToEnd, ShadowsShowTheTarget) {
    const Outcome outcome = ask({"render"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json made = manifest();
    const Json& image = made["figures"]["check"]["images"].at(0);
    EXPECT_GE(image["iou"], 0.85);
    EXPECT_EQ(image["sun"]["azimuth"], 215.0);
    const Json& figures = image["figures"];
    EXPECT_GT(figures["iou_1x1"], 0.85);
    EXPECT_GT(figures["standing_out"], 3.0);
    EXPECT_EQ(figures["other_suns"]["suns"].size(), 10u);
    for (const char* file :
         {"terrain.exr", "terrain.tif", "preview.png", "shadow/cast.png",
          "shadow/target.png", "shadow/overlay.png", "shadow/sun-clock.png",
          "pov/overhead.pov", "frames/overhead.exr", "frames/overhead.png"}) {
        EXPECT_GT(fs::file_size(out / file), 0u) << file;
        EXPECT_TRUE(std::ranges::any_of(made["outputs"], [&](const Json& output) {
            return output["file"] == file;
        })) << file;
    }
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});

    const Field<Rgb> frame = read_exr_rgb(out / "frames/overhead.exr");
    EXPECT_EQ(frame.width(), 64);  // a third of 192
    const auto [least, most] = std::ranges::minmax(frame, {}, [](Rgb c) { return c[1]; });
    EXPECT_GT(most[1], 2.0f * least[1]) << "light and shadow";
}

TEST_F(EndToEnd, AnUnchangedSceneIsNotDoneAgain) {
    ASSERT_EQ(ask({"render"}).code, 0);
    const auto before = times();
    const Outcome again = ask({"render"});
    EXPECT_EQ(again.code, 0);
    EXPECT_NE(again.err.find("nothing to do"), std::string::npos) << again.err;
    EXPECT_EQ(times(), before);
}

TEST_F(EndToEnd, OnlyWhatChangedIsDoneAgain) {
    ASSERT_EQ(ask({"render"}).code, 0);
    auto before = times();
    ASSERT_EQ(ask({"render", "--set", "render.colour.exposure=1.0"}).code, 0);
    const auto after = times();
    EXPECT_EQ(after.at("terrain.exr"), before.at("terrain.exr"));
    EXPECT_EQ(after.at("pov/overhead.exr"), before.at("pov/overhead.exr"))
        << "no new trace";
    EXPECT_NE(after.at("frames/overhead.png"), before.at("frames/overhead.png"));
}

TEST_F(EndToEnd, AnEqualPovIsNotTracedAgain) {
    ASSERT_EQ(ask({"render"}).code, 0);
    const auto before = times();
    fs::remove(out / "pov/overhead.ini");
    ASSERT_EQ(ask({"render"}).code, 0);
    EXPECT_NE(times().at("pov/overhead.pov"), before.at("pov/overhead.pov"));
    EXPECT_EQ(times().at("pov/overhead.exr"), before.at("pov/overhead.exr"));
}

TEST_F(EndToEnd, ALostFrameIsMadeAgain) {
    ASSERT_EQ(ask({"render"}).code, 0);
    const auto before = times();
    fs::remove(out / "frames/overhead.png");
    ASSERT_EQ(ask({"render"}).code, 0);
    EXPECT_TRUE(fs::exists(out / "frames/overhead.png"));
    EXPECT_EQ(times().at("terrain.exr"), before.at("terrain.exr"));
}

TEST_F(EndToEnd, ThreadsDoNotChangeTheLand) {
    ASSERT_EQ(ask({"check", "-o", "one", "--threads", "1"}).code, 0);
    ASSERT_EQ(ask({"check", "-o", "four", "--threads", "4"}).code, 0);
    EXPECT_EQ(read_exr(folder / "one/terrain.exr"),
              read_exr(folder / "four/terrain.exr"));
    EXPECT_EQ(read_grey(open_source(folder / "one/shadow/cast.png")),
              read_grey(open_source(folder / "four/shadow/cast.png")));
}

TEST_F(EndToEnd, ManifestIsEqualButForTimings) {
    ASSERT_EQ(ask({"check"}).code, 0);
    const Json first = manifest();
    EXPECT_GT(first["timings"]["peak_memory"], 1'000'000);
    fs::remove_all(out);
    ASSERT_EQ(ask({"check", "--threads", "1"}).code, 0);
    EXPECT_EQ(without_timings(manifest()).dump(1), without_timings(first).dump(1));
}

TEST_F(EndToEnd, DamagedCacheIsMadeAgain) {
    ASSERT_EQ(ask({"synth"}).code, 0);
    const Field<float> land = read_exr(out / "terrain.exr");
    for (const std::string& file : files_below(out / ".cache")) {
        folder.write("out/land/.cache/" + file, "damaged");
    }
    fs::remove(out / "terrain.exr");
    const Outcome outcome = ask({"synth"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(read_exr(out / "terrain.exr"), land);
}

TEST_F(EndToEnd, ACheckThatFallsShortStopsBeforeThePov) {
    const std::vector<std::string> strict = {"render", "--set",
                                             "terrain.stage.0.image.0.min_iou=1.0"};
    const Outcome outcome = ask(strict);
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("IoU"), std::string::npos) << outcome.err;
    EXPECT_TRUE(fs::exists(out / "shadow/overlay.png"));
    EXPECT_TRUE(fs::exists(out / "manifest.json"));
    EXPECT_FALSE(fs::exists(out / "pov"));
    EXPECT_FALSE(fs::exists(out / "frames"));
    EXPECT_EQ(ask(strict).code, 3) << "also when the check is not done again";

    std::vector<std::string> forced = strict;
    forced.push_back("--force");
    EXPECT_EQ(ask(forced).code, 0);
    EXPECT_TRUE(fs::exists(out / "frames/overhead.png"));
}

TEST_F(EndToEnd, HeightsThatAreNotOurs) {
    ASSERT_EQ(ask({"synth"}).code, 0);
    folder.write("wide.svg", kBar);
    const Outcome good =
        run({folder.path()}, {"check", "--height", "out/land/terrain.tif", "--sun",
                              "215,25", "--target", "bar.svg"});
    EXPECT_EQ(good.code, 0) << good.err;
    EXPECT_TRUE(fs::exists(folder / "out/terrain/shadow/overlay.png"));
    const Outcome wrong_sun =
        run({folder.path()}, {"check", "--height", "out/land/terrain.tif", "--sun",
                              "35,25", "--target", "bar.svg"});
    EXPECT_EQ(wrong_sun.code, 3) << wrong_sun.err;
    // A window that has nothing of the image: nothing is wrong in it.
    folder.write("corner.svg",
                 R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">)"
                 R"(<path d="M0 0H10V10H0Z" fill="black"/></svg>)");
    const Outcome no_window =
        run({folder.path()}, {"check", "--height", "out/land/terrain.tif", "--sun",
                              "215,25", "--target", "bar.svg", "--window", "corner.svg"});
    EXPECT_EQ(no_window.code, 2) << no_window.err;
}

TEST_F(EndToEnd, DryRunWritesNothing) {
    const Outcome outcome = ask({"render", "--dry-run"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* word : {"pareidolia", "check", "trace overhead", "to do", "MB"}) {
        EXPECT_NE(outcome.out.find(word), std::string::npos) << outcome.out;
    }
    EXPECT_FALSE(fs::exists(folder / "out"));
}
