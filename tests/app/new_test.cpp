// A scene of one's own from an example that ships.
#include <gtest/gtest.h>

#include "config/reader/scene.h"
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
