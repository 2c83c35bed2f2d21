#include "app/pipeline/stage_memory.h"

#include <gtest/gtest.h>

#include "field/files.h"
#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;

namespace {

using Names = std::vector<std::string>;

struct StageMemoryTest : testing::Test {
    test::TemporaryFolder folder;

    std::string remembered(const StageMemory& memory) const {
        const fs::path& last = memory.files().last;
        return fs::exists(last) ? read_text(last) : "";
    }
    // A run that keeps `text`; returns what it found.
    std::string run(StageMemory memory, const std::string& text) const {
        const std::string found = remembered(memory);
        write_text(memory.files().next, text);
        memory.end_run();
        return found;
    }
    StageMemory of_run(std::uint64_t key) const {
        return {folder.path(), 1, "texture", key};
    }
    StageMemory of_method(const std::string& method) const {
        return {folder.path(), 1, method};
    }
};

}  // namespace

TEST_F(StageMemoryTest, OneFileIsReplacedEachTime) {
    EXPECT_EQ(run(of_method("distance"), "a"), "");
    EXPECT_EQ(run(of_method("distance"), "b"), "a");
    EXPECT_TRUE(of_method("distance").is_of_last_run());
    EXPECT_EQ(test::files_below(folder.path()).size(), 1u);
}

TEST_F(StageMemoryTest, ARunFindsTheOneBefore) {
    EXPECT_FALSE(of_run(1).is_of_last_run());
    EXPECT_EQ(run(of_run(1), "a"), "");
    EXPECT_EQ(run(of_run(2), "b"), "a");
    EXPECT_EQ(run(of_run(3), "c"), "b");
    EXPECT_TRUE(of_run(3).is_of_last_run());
    EXPECT_FALSE(of_run(2).is_of_last_run());
}

TEST_F(StageMemoryTest, ARunMadeAgainFindsWhatItFoundFirst) {
    run(of_run(1), "a");
    run(of_run(2), "b");
    EXPECT_EQ(run(of_run(2), "b"), "a");
    EXPECT_EQ(run(of_run(2), "b"), "a");
    EXPECT_EQ(run(of_run(3), "c"), "b");
}

TEST_F(StageMemoryTest, AnEditTakenBackIsAnEdit) {
    run(of_run(1), "a");
    run(of_run(2), "b");
    EXPECT_EQ(run(of_run(1), "a again"), "b");
    EXPECT_EQ(run(of_run(3), "c"), "a again");
}

TEST_F(StageMemoryTest, AnInterruptedRunIsNoRun) {
    run(of_run(1), "a");
    write_text(of_run(2).files().next, "half");
    EXPECT_FALSE(of_run(2).is_of_last_run());
    EXPECT_EQ(run(of_run(3), "c"), "a");
}

TEST_F(StageMemoryTest, KeepsTwoRuns) {
    for (std::uint64_t key = 1; key <= 5; ++key) run(of_run(key), "bytes");
    EXPECT_EQ(test::files_below(folder.path()).size(), 3u);
}

TEST_F(StageMemoryTest, StaysUntilTheStageIsOfAnotherMethod) {
    run(of_run(1), "a");
    run(of_method("texture"), "not coherent for once");
    EXPECT_EQ(run(of_run(2), "b"), "a");
    run(of_method("distance"), "passes");
    EXPECT_EQ(test::files_below(folder.path()), Names{"stage-1.distance"});
}

TEST_F(StageMemoryTest, OtherStagesAreForgottenWithThem) {
    for (const char* name : {"stage-1.a", "stage-2.b", "stage-12.c", "steps.jsonl"})
        folder.write(name, "x");
    run({folder.path(), 3, "distance"}, "y");
    forget_stages_after(folder.path(), 2);
    EXPECT_EQ(test::files_below(folder.path()),
              (Names{"stage-1.a", "stage-2.b", "steps.jsonl"}));
}

TEST_F(StageMemoryTest, DamagedListOfRunsIsNone) {
    for (const char* text : {"", "zebra", "12345678901234567890123 1", "-1"}) {
        run(of_run(1), "a");
        folder.write("stage-1.texture.runs", text);
        EXPECT_EQ(remembered(of_run(2)), "") << text;
        run(of_run(2), "b");
        EXPECT_TRUE(of_run(2).is_of_last_run()) << text;
    }
}
