// A scene of one's own from an example that ships.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "app/manual.h"
#include "config/reader/scene.h"
#include "field/files.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

struct New : testing::Test {
    TemporaryFolder folder;
    Outcome ask(std::vector<std::string> more) const {
        more.insert(more.begin(), "new");
        return run({folder.path()}, more);
    }
    void expect_refused(const std::vector<std::string>& more, const std::string& words) {
        const Outcome outcome = ask(more);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }
};

}  // namespace

TEST_F(New, EveryExampleCanBeBegunFrom) {
    int examples = 0;
    for (const auto& entry : fs::directory_iterator(CYDONIA_SOURCE_DIR "/scenes")) {
        if (!fs::exists(entry.path() / "scene.toml")) continue;
        const std::string name = entry.path().filename().string();
        const Outcome outcome = ask({"own-" + name, "--from", name});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        ++examples;
    }
    EXPECT_GT(examples, 40);
}

// Every key of every example says what it is, and the scene is the same.
TEST_F(New, IsCommentedLineByLine) {
    const std::regex key(R"([a-z_]+ = .*)");
    for (const char* from : {"text", "grand-canyon", "wooded-valley", "mountain-range"}) {
        const std::string name = std::string("own-") + from;
        ASSERT_EQ(ask({name, "--from", from}).code, 0);
        const fs::path file = folder / name / "scene.toml";
        std::istringstream lines(read_text(file));
        std::string before;
        for (std::string line; std::getline(lines, line); before = line)
            if (std::regex_match(line, key)) {
                EXPECT_TRUE(line.find('#') != line.npos || before.starts_with("#"))
                    << line;
            }
        const auto own = config::Scene::load(file).at(0.0);
        const auto example = config::Scene::load(fs::path(CYDONIA_SOURCE_DIR "/scenes") /
                                                 from / "scene.toml")
                                 .at(0.0);
        EXPECT_EQ(own.render_text, example.render_text);
        ASSERT_EQ(own.stages.size(), example.stages.size());
        for (std::size_t i = 0; i < own.stages.size(); ++i)
            EXPECT_EQ(own.stages[i].text, example.stages[i].text);
    }
    const std::string text = read_text(folder / "own-text/scene.toml");
    EXPECT_NE(text.find("\nblending_bias = 6.0  # b: how strongly the highest of"),
              text.npos);
    EXPECT_NE(text.find("apart: least distance between two"), text.npos);
}

TEST(Commented, KeepsWhatIsThere) {
    const Manual manual(
        "## `[a]`\n| `k` | metres | `1` | `x`, `y` | what `k` [is](there) |\n"
        "## Other\n| `k` | | | | elsewhere |\n"
        "## `[[terrain.stage]]` with `method = \"m\"`\n| `k` | | | | of m |\n");
    EXPECT_EQ(commented("k = 1\n[a]\nk = \"#\"\nk = 2 # own\n  k = 3\nz = 1\n", manual),
              "k = 1\n[a]\nk = \"#\"  # x, y: what k is (metres)\nk = 2 # own\n  k = 3\n"
              "z = 1\n");
    EXPECT_EQ(commented("[[terrain.stage]]\nk = 1\nmethod = \"m\"\n", manual),
              "[[terrain.stage]]\nk = 1  # of m\nmethod = \"m\"\n");
}

TEST_F(New, APictureTakesThePlaceOfTheExamples) {
    folder.write("bar.svg", kBar);
    ASSERT_EQ(ask({"mine", "--picture", "bar.svg"}).code, 0);
    const auto scene = config::Scene::load(folder / "mine/scene.toml").at(0.0);
    ASSERT_EQ(scene.stages.back().sources.size(), 1u);
    EXPECT_EQ(scene.stages.back().sources[0].name(), "picture.svg");
    EXPECT_FALSE(fs::exists(folder / "mine/horse.svg"));
}

TEST_F(New, BadInput) {
    folder.write("full/x", "");
    expect_refused({"full"}, "exists; choose another name");
    expect_refused({"a", "--from", "txt"}, "did you mean 'text'?");
    expect_refused({"a", "--from", "../scenes/text"}, "no example scene");
    expect_refused({"a", "--picture", "none.png"}, "'none.png' is no PNG");
    expect_refused({"a", "--picture", "full/x"}, "'full/x' is no PNG");
    folder.write("bar.svg", kBar);
    expect_refused({"a", "--from", "hills", "--picture", "bar.svg"}, "--from horse");
    EXPECT_FALSE(fs::exists(folder / "a"));
}
