// The command line itself, through the program that was built.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/program.h"

using namespace cydonia::test;

namespace {

Outcome ask(const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    return run({folder.path()}, arguments);
}

int lines_in(const std::string& text) {
    return static_cast<int>(std::ranges::count(text, '\n'));
}

void expect_fits_a_screen(const std::string& help) {
    EXPECT_LE(lines_in(help), 24) << help;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
    EXPECT_NE(help.find("Example:\n  cydonia "), std::string::npos) << help;
}

void expect_wrong_usage(const Outcome& outcome, const std::string& culprit) {
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(lines_in(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(culprit), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("--help)"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

}  // namespace

TEST(Usage, HelpFitsAScreenAndEndsWithAnExample) {
    expect_fits_a_screen(ask({}).out);
    expect_fits_a_screen(ask({"--help"}).out);
    for (const char* command :
         {"new", "render", "sweep", "turntable", "film", "synth", "check", "report",
          "emit", "export", "farm", "reproduce", "gallery", "watch", "validate", "schema",
          "info", "frame-for-sketch", "library"}) {
        const Outcome outcome = ask({command, "--help"});
        EXPECT_EQ(outcome.code, 0);
        EXPECT_NE(outcome.out.find(command), std::string::npos);
        expect_fits_a_screen(outcome.out);
    }
}

TEST(Usage, Version) {
    const Outcome outcome = ask({"--version"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(outcome.out.starts_with("cydonia 0.")) << outcome.out;
}

TEST(Usage, UnknownCommand) { expect_wrong_usage(ask({"rendr"}), "'rendr'"); }

TEST(Usage, UnknownOption) {
    expect_wrong_usage(ask({"render", "a.toml", "--fast"}), "'--fast'");
}

TEST(Usage, MissingScene) {
    expect_wrong_usage(ask({"render"}), "SCENE");
    expect_wrong_usage(ask({"check"}), "--height");
}

TEST(Usage, UnknownQuality) {
    expect_wrong_usage(ask({"render", "a.toml", "--quality", "best"}), "best");
}

TEST(Usage, ThreadsOutOfRange) {
    expect_wrong_usage(ask({"render", "a.toml", "--threads", "0"}), "--threads");
    expect_wrong_usage(ask({"render", "a.toml", "--threads", "x"}), "--threads");
}

TEST(Usage, SetWithoutAValue) {
    expect_wrong_usage(ask({"render", "a.toml", "--set"}), "--set");
}

TEST(Usage, HeightNeedsSunAndTarget) {
    expect_wrong_usage(ask({"check", "--height", "a.tif"}), "--sun");
    expect_wrong_usage(ask({"check", "--height", "a.tif", "--sun", "1"}), "--sun");
    expect_wrong_usage(ask({"check", "--height", "a.tif", "--sun", "1,2"}), "--target");
    expect_wrong_usage(ask({"check", "a.toml", "--height", "a.tif"}), "--height");
    expect_wrong_usage(ask({"check", "--height", "a.tif", "--sun", "1,2", "--target",
                            "t.png", "--set", "a=1"}),
                       "--set");
    expect_wrong_usage(ask({"check", "--height", "a.tif", "--sun", "1,2", "--target",
                            "t.png", "--explain"}),
                       "--explain");
}

TEST(Usage, ControlCharactersDoNotReachTheTerminal) {
    const Outcome outcome = ask({"validate", "a\x1b[31m.toml"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("a?[31m.toml"), std::string::npos) << outcome.err;
}

TEST(Usage, EachFileOfAStageIsNamedOnce) {
    const TemporaryFolder folder;
    folder.write("a.tif", "a model");
    folder.write("scene.toml",
                 "[[terrain.stage]]\nmethod = 'texture'\n"
                 "exemplars = ['a.tif', 'package:jacksboro', 'a.tif']\n");
    const Outcome outcome = run({folder.path()}, {"info", "scene.toml"});
    EXPECT_NE(outcome.out.find("  stage: texture, a.tif, package:jacksboro\n"),
              std::string::npos)
        << outcome.out << outcome.err;
}

// Editors show what a key is.
TEST(Usage, TheSchemaDescribesTheKeysOfEveryMethod) {
    const auto schema = nlohmann::json::parse(ask({"schema"}).out);
    const auto& terrain = schema.at("properties").at("terrain").at("properties");
    EXPECT_EQ(terrain.at("extent").at("description"),
              "size of the land from west to east and from south to north (metres)");
    int bodies = 0;
    for (const auto& stage : terrain.at("stage").at("items").at("anyOf"))
        for (const auto& [key, value] : stage.at("properties").items()) {
            EXPECT_TRUE(value.contains("description")) << key;
            bodies += key == "blending_bias";
        }
    EXPECT_EQ(bodies, 1);
    const auto& camera =
        schema.at("properties").at("render").at("properties").at("camera");
    EXPECT_EQ(camera.at("items").at("properties").at("azimuth").at("description"),
              "direction from the centre to the camera; oblique and orbit (degrees)");
}
