#include "app/pipeline/ledger.h"

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;

namespace {

Entry entry_with(std::uint64_t key, std::vector<std::string> outputs) {
    return {key, std::move(outputs), {}, {{"iou", 0.5}}, 1.5, 1000};
}

// A folder in which step "a" with key 7 made one.png.
struct FinishedStep {
    test::TemporaryFolder folder;
    FinishedStep() {
        folder.write(".cache/x", "");
        folder.write("one.png", "12345");
        Ledger(folder.path()).record("a", entry_with(7, {"one.png"}));
    }
};

}  // namespace

TEST(Ledger, RemembersAcrossRuns) {
    const FinishedStep made;
    const Ledger ledger(made.folder.path());
    const Entry* entry = ledger.finished("a", 7);
    ASSERT_TRUE(entry);
    EXPECT_EQ(entry->outputs, std::vector<std::string>{"one.png"});
    EXPECT_EQ(entry->result["iou"], 0.5);
    EXPECT_EQ(entry->seconds, 1.5);
}

TEST(Ledger, OtherInputsAreNotFinished) {
    const FinishedStep made;
    EXPECT_FALSE(Ledger(made.folder.path()).finished("a", 8));
    EXPECT_FALSE(Ledger(made.folder.path()).finished("b", 7));
}

TEST(Ledger, MissingOrCutOutputIsNotFinished) {
    const FinishedStep made;
    made.folder.write("one.png", "123");
    EXPECT_FALSE(Ledger(made.folder.path()).finished("a", 7));
    fs::remove(made.folder / "one.png");
    EXPECT_FALSE(Ledger(made.folder.path()).finished("a", 7));
}

TEST(Ledger, DamagedOutputOfTheSameSizeIsNotFinished) {
    const FinishedStep made;
    const auto later =
        fs::last_write_time(made.folder / "one.png") + std::chrono::seconds(2);
    fs::last_write_time(made.folder / "one.png", later);
    EXPECT_TRUE(Ledger(made.folder.path()).finished("a", 7)) << "copied, not changed";
    made.folder.write("one.png", "12x45");
    fs::last_write_time(made.folder / "one.png", later);
    EXPECT_FALSE(Ledger(made.folder.path()).finished("a", 7));
}

TEST(Ledger, DamagedFileIsAnEmptyLedger) {
    const FinishedStep made;
    for (const char* text : {"", "{", "[]", "{\"a\": 1}", "{\"a\": {\"key\": \"x\"}}"}) {
        made.folder.write(".cache/steps.json", text);
        EXPECT_FALSE(Ledger(made.folder.path()).finished("a", 7)) << text;
    }
}

TEST(Ledger, RemovesWhatAStepNoLongerMakes) {
    const FinishedStep made;
    made.folder.write("two.png", "1");
    Ledger(made.folder.path()).record("a", entry_with(8, {"two.png"}));
    EXPECT_FALSE(fs::exists(made.folder / "one.png"));
    EXPECT_TRUE(fs::exists(made.folder / "two.png"));
}

TEST(Ledger, RemovesNothingOutsideTheFolder) {
    const test::TemporaryFolder outside;
    const fs::path precious = outside.write("precious", "1");
    const FinishedStep made;
    for (const fs::path& path : {precious, fs::relative(precious, made.folder.path())}) {
        const Json lie = {{"a",
                           {{"key", 7},
                            {"outputs", {path.string()}},
                            {"sizes", {1}},
                            {"result", Json::object()},
                            {"seconds", 1.0},
                            {"peak_memory", 1}}}};
        made.folder.write(".cache/steps.json", lie.dump());
        Ledger(made.folder.path()).record("a", entry_with(9, {}));
        EXPECT_TRUE(fs::exists(precious)) << path;
    }
}

// Processes that share the folder do not lose each other's steps, nor what they recorded
// before they were killed and begun again; the next that has it alone takes all in.
TEST(Ledger, StepsRecordedApartComeTogether) {
    const FinishedStep made;
    const auto& folder = made.folder;
    for (const char* file : {"two.png", "three.png", "four.png"})
        folder.write(file, file);
    Ledger first(folder.path()), second(folder.path());
    first.record_apart("first");
    second.record_apart("second");
    first.record("b", entry_with(1, {"two.png"}));
    second.record("c", entry_with(2, {"three.png"}));
    Ledger again(folder.path());
    again.record_apart("first");
    again.record("d", entry_with(3, {"four.png"}));

    Ledger all(folder.path());
    const auto expect_all = [](const Ledger& ledger) {
        EXPECT_TRUE(ledger.finished("a", 7));
        EXPECT_TRUE(ledger.finished("b", 1));
        EXPECT_TRUE(ledger.finished("c", 2));
        EXPECT_TRUE(ledger.finished("d", 3));
    };
    expect_all(all);
    all.record("a", entry_with(7, {"one.png"}));
    EXPECT_TRUE(fs::is_empty(folder / ".cache/steps"));
    expect_all(Ledger(folder.path()));
}

TEST(Ledger, OfAStepThatSeveralMadeTheLastCounts) {
    const FinishedStep made;
    for (const auto& [name, key] : {std::pair{"z", 1u}, {"a", 2u}}) {
        Ledger ledger(made.folder.path());
        ledger.record_apart(name);
        ledger.record("b", entry_with(key, {"one.png"}));
        const auto file = made.folder / (".cache/steps/" + std::string(name) + ".json");
        fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(key));
    }
    EXPECT_TRUE(Ledger(made.folder.path()).finished("b", 2));
    made.folder.write(".cache/steps/y.json", "{ damaged");
    EXPECT_TRUE(Ledger(made.folder.path()).finished("b", 2));
}
