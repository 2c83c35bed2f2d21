// --explain: what stages show lies in the output folder, and is there when asked for.
#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia::test;

namespace {

struct ExplainOption : testing::Test {
    TemporaryFolder folder;
    const fs::path shown = folder / "out/land/explain";
    ExplainOption() { folder.write("land.toml", kSmallScene); }

    Outcome synth(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"synth", "land.toml"});
        const Outcome outcome = run({folder.path()}, more);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome;
    }
    bool nothing_to_do(const Outcome& outcome) const {
        return outcome.err.find("nothing to do") != std::string::npos;
    }
};

}  // namespace

TEST_F(ExplainOption, ShowsEveryStageByItsNumber) {
    folder.write("land.toml", kSmallScene +
                                  "[[terrain.stage]]\nmethod = \"distance\"\n"
                                  "[[terrain.stage.group]]\npeaks = { count = 2 }\n");
    synth({"--explain"});
    for (const char* name : {"1-features.csv", "1-features.png", "1-highest.png",
                             "2-features.csv", "2-search-00001.png"}) {
        EXPECT_TRUE(fs::exists(shown / name)) << name;
    }
    EXPECT_FALSE(fs::exists(shown / "2-search-00002.png"));
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
}

TEST_F(ExplainOption, AFinishedStageIsRunAgainWhereItsExplanationIsMissing) {
    synth();
    EXPECT_FALSE(fs::exists(shown));
    EXPECT_FALSE(nothing_to_do(synth({"--explain"})));
    EXPECT_TRUE(nothing_to_do(synth({"--explain"})));
    EXPECT_TRUE(nothing_to_do(synth()));
    fs::remove(shown / "1-visits.png");
    EXPECT_FALSE(nothing_to_do(synth({"--explain"})));
    EXPECT_TRUE(fs::exists(shown / "1-visits.png"));
}

TEST_F(ExplainOption, IsGoneWhenTheLandIsAnother) {
    synth({"--explain"});
    const auto before = files_below(shown);
    EXPECT_FALSE(before.empty());
    synth({"--set", "seed=8"});
    EXPECT_EQ(files_below(shown), std::vector<std::string>{});
    synth({"--set", "seed=8", "--explain"});
    EXPECT_EQ(files_below(shown), before);
}
