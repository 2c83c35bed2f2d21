// A day over a small land, through the program that was built, POV-Ray and ffmpeg.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "field/image.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;
using Json = nlohmann::ordered_json;

namespace {

struct Sweep : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/land";
    Sweep() {
        folder.write("land.toml", kShadowScene);
        folder.write("bar.svg", kBar);
    }

    Outcome ask(std::vector<std::string> more = {}, const Start& how = {}) const {
        std::vector<std::string> arguments{"sweep", "land.toml", "--quality",
                                           "draft", "--force",   "--frames",
                                           "3",     "--set",     "terrain.samples=32"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        Start start = how;
        start.folder = folder.path();
        return run(start, arguments);
    }
    void expect_refused(const Outcome& outcome, const std::string& words) const {
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(folder / "out"));
    }
    Json manifest() const {
        std::ifstream in(out / "manifest.json");
        return Json::parse(in);
    }
    std::map<std::string, fs::file_time_type> times() const {
        std::map<std::string, fs::file_time_type> times;
        for (const std::string& file : files_below(out))
            if (!file.starts_with(".cache/"))
                times[file] = fs::last_write_time(out / file);
        return times;
    }
    std::set<std::string> noted_files() const {
        std::ifstream in(out / ".cache/steps.jsonl");
        std::set<std::string> files;
        for (std::string line; std::getline(in, line);) {
            const Json record = Json::parse(line);
            for (const std::string file : record.at("outputs")) files.insert(file);
        }
        return files;
    }
    Field<Rgba8> picture(const std::string& name) const {
        return read_rgba(open_source(out / "frames" / name));
    }
    // A search path with POV-Ray and no ffmpeg.
    std::string path_without_ffmpeg() const {
        folder.write_script("bin/povray", "exec /usr/bin/povray \"$@\"\n");
        return (folder / "bin").string();
    }
};

double mean(const Field<Rgb>& frame) {
    double sum = 0.0;
    for (const Rgb& pixel : frame) sum += pixel[1];
    return sum / static_cast<double>(frame.size());
}

}  // namespace

TEST_F(Sweep, FramesAndVideo) {
    const Outcome outcome = ask();
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* file :
         {"day-0001.png", "day-0002.exr", "day-0003.png", "day.mp4", "day.webp"})
        EXPECT_GT(fs::file_size(out / "frames" / file), 0u) << file;
    EXPECT_FALSE(fs::exists(out / "frames/overhead.png")) << "no still was asked for";
    EXPECT_NE(outcome.err.find("'bar' appears at"), std::string::npos) << outcome.err;
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});

    const Json day = manifest()["figures"]["plan day"];
    EXPECT_EQ(day["key_frame"], "day-0002");
    EXPECT_EQ(day["shots"].at(1)["sun"]["azimuth"], 215.0);
    EXPECT_EQ(day["shots"].at(1)["sun"]["elevation"], 25.0);

    // Dusk and dawn are dark beside the day in the light itself and, all being exposed
    // alike, in what is shown.
    const double noon = mean(read_exr_rgb(out / "frames/day-0002.exr"));
    EXPECT_LT(mean(read_exr_rgb(out / "frames/day-0001.exr")), 0.3 * noon);
    const auto brightness = [&](const char* name) {
        double sum = 0.0;
        for (const Rgba8& pixel : picture(name)) sum += pixel[1];
        return sum;
    };
    EXPECT_LT(brightness("day-0001.png"), 0.6 * brightness("day-0002.png"));
}

TEST_F(Sweep, AnUnchangedDayIsNotFilmedAgain) {
    ASSERT_EQ(ask().code, 0);
    const auto before = times();
    const Outcome again = ask();
    EXPECT_EQ(again.code, 0);
    EXPECT_NE(again.err.find("nothing to do"), std::string::npos) << again.err;
    EXPECT_NE(again.err.find("'bar' appears at"), std::string::npos) << again.err;
    EXPECT_EQ(times(), before);
}

TEST_F(Sweep, OnlyTheLostFrameIsMadeAgain) {
    ASSERT_EQ(ask().code, 0);
    const auto before = times();
    const Field<Rgba8> first = picture("day-0001.png");
    for (const char* file :
         {"frames/day-0001.png", "frames/day-0001.exr", "pov/day-0001.exr"})
        fs::remove(out / file);
    ASSERT_EQ(ask().code, 0);
    EXPECT_EQ(picture("day-0001.png"), first);
    for (const char* file : {"frames/day-0002.png", "frames/day-0003.exr",
                             "pov/day-0002.exr", "pov/day-0001.pov"})
        EXPECT_EQ(times().at(file), before.at(file)) << file;
}

TEST_F(Sweep, AnInterruptedDayGoesOn) {
    // More than workers: each may have written one that it has not yet recorded.
    const auto a_frame_is_there = [&] {
        return std::ranges::count_if(
                   files_below(out / "frames"),
                   [](const std::string& file) { return file.ends_with(".png"); }) > 2;
    };
    const std::vector<std::string> command{
        "sweep", "land.toml", "--quality", "draft", "--force",           "--threads",
        "2",     "--frames",  "9",         "--set", "terrain.samples=32"};
    const Outcome stopped =
        run_and_signal({folder.path()}, command, SIGINT, a_frame_is_there);
    ASSERT_EQ(stopped.signal, SIGINT) << stopped.err;
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
    EXPECT_FALSE(fs::exists(out / "frames/day.mp4"));
    const auto before = times();
    // Every file of every finished step. What was written but not yet noted when the
    // signal came is not finished.
    const std::set<std::string> noted = noted_files();
    ASSERT_TRUE(std::ranges::any_of(
        noted, [](const auto& file) { return file.starts_with("frames/"); }));
    ASSERT_LT(
        std::ranges::count_if(
            before, [](const auto& file) { return file.first.starts_with("frames/"); }),
        48);
    ASSERT_EQ(run({folder.path()}, command).code, 0);
    EXPECT_TRUE(fs::exists(out / "frames/day-0009.png"));
    for (const std::string& file : noted) {
        EXPECT_EQ(times().at(file), before.at(file)) << file;
    }
}

TEST_F(Sweep, WorkersDoNotChangeThePixels) {
    ASSERT_EQ(ask({"-o", "one", "--threads", "1"}).code, 0);
    ASSERT_EQ(ask({"-o", "four", "--threads", "4"}).code, 0);
    for (const char* file : {"day-0001.exr", "day-0002.exr", "day-0003.exr"})
        EXPECT_EQ(read_exr_rgb(folder / "one/frames" / file),
                  read_exr_rgb(folder / "four/frames" / file))
            << file;
}

TEST_F(Sweep, FewerFramesLeaveNoneOfTheOld) {
    ASSERT_EQ(ask().code, 0);
    ASSERT_EQ(ask({"--set", "frames.count=2"}).code, 0);
    EXPECT_TRUE(fs::exists(out / "frames/day-0003.png")) << "--frames goes first";
    ASSERT_EQ(run({folder.path()}, {"sweep", "land.toml", "--quality", "draft", "--force",
                                    "--set", "terrain.samples=32", "--frames", "2"})
                  .code,
              0);
    EXPECT_FALSE(fs::exists(out / "frames/day-0003.png"));
}

TEST_F(Sweep, WithoutFfmpegTheFramesStay) {
    const Outcome outcome = ask({}, {.environment = {{"PATH", path_without_ffmpeg()}}});
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_NE(outcome.err.find("apt install ffmpeg"), std::string::npos) << outcome.err;
    EXPECT_LT(outcome.err.find("the video is not"), outcome.err.find("film day"))
        << "said before the work";
    EXPECT_TRUE(fs::exists(out / "frames/day-0003.png"));
    const auto before = times();
    EXPECT_EQ(ask().code, 0);
    EXPECT_TRUE(fs::exists(out / "frames/day.mp4"));
    EXPECT_EQ(times().at("frames/day-0003.png"), before.at("frames/day-0003.png"));
}

TEST_F(Sweep, AFailingPovrayStopsAllWorkers) {
    folder.write_script("bin/povray", "echo 'Fatal error: no light' >&2; exit 1\n");
    const std::string path = (folder / "bin").string() + ":" + std::getenv("PATH");
    const Outcome outcome = ask({}, {.environment = {{"PATH", path}}});
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_NE(outcome.err.find("no light"), std::string::npos) << outcome.err;
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
    EXPECT_EQ(ask().code, 0) << "goes on";
}

TEST_F(Sweep, OddSizesAndAPlace) {
    const Outcome outcome = ask({"--set", "render.camera[0].size=[99, 57]", "--set",
                                 "frames.place={latitude = 47.05, longitude = 8.3}",
                                 "--set", "frames.date=2026-06-21"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("on 21 June 2026"), std::string::npos) << outcome.err;
    EXPECT_GT(fs::file_size(out / "frames/day.mp4"), 0u);
}

TEST_F(Sweep, DryRunTellsThePlan) {
    const Outcome outcome = ask({"--dry-run"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("film day"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("trace overhead"), std::string::npos) << outcome.out;
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(Sweep, BadRequests) {
    const std::string place = "frames.place={latitude = 47, longitude = 8}";
    expect_refused(ask({"--frames", "0"}), "--frames");
    expect_refused(ask({"--set", "frames.camera=sky"}), "no camera 'sky'");
    expect_refused(ask({"--set", "frames.place={latitude = 91, longitude = 8}"}),
                   "91 degrees is out of range");
    expect_refused(ask({"--set", place, "--set", "frames.date=2026-02-31"}),
                   "there is no day 2026-02-31");
    expect_refused(ask({"--set", "frames.place={latitude = 80, longitude = 8}", "--set",
                        "frames.date=2026-12-21"}),
                   "stays below 2 degrees");
    folder.write("land.toml", kSmallScene);
    expect_refused(ask(), "no shadow image");
}
