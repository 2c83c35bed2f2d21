#include "app/pipeline/ledger.h"

#include <gtest/gtest.h>

#include <fstream>

#include "field/error.h"
#include "field/files.h"
#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;

namespace {

StepRecord record_with(std::uint64_t key, std::vector<std::string> outputs) {
    return {key, std::move(outputs), {}, {{"iou", 0.5}}, 1.5, 1000};
}

// A folder in which step "a" with key 7 made one.png.
struct FinishedStep {
    test::TemporaryFolder folder;
    FinishedStep() {
        folder.write(".cache/x", "");
        folder.write("one.png", "12345");
        Ledger(folder.path()).record("a", record_with(7, {"one.png"}));
    }
};

// Bytes that this process has handed to write() so far.
std::uint64_t bytes_written() {
    std::ifstream in("/proc/self/io");
    std::uint64_t bytes = 0;
    for (std::string name; in >> name >> bytes;)
        if (name == "wchar:") return bytes;
    return 0;
}

std::uint64_t bytes_of_recording(int steps) {
    const test::TemporaryFolder folder;
    Ledger ledger(folder.path());
    const std::uint64_t before = bytes_written();
    for (int i = 0; i < steps; ++i)
        ledger.record("step " + std::to_string(1000 + i), record_with(7, {}));
    return bytes_written() - before;
}

}  // namespace

TEST(Ledger, RemembersAcrossRuns) {
    const FinishedStep made;
    const Ledger ledger(made.folder.path());
    const StepRecord* record = ledger.finished("a", 7);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->outputs, std::vector<std::string>{"one.png"});
    EXPECT_EQ(record->result["iou"], 0.5);
    EXPECT_EQ(record->seconds, 1.5);
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
    for (const char* text : {"", "{", "[]", "7", "{\"a\": 1}", "{\"step\": \"a\"}",
                             "{\"step\": \"a\", \"key\": \"x\"}", "\n\n", "\xff\n"}) {
        made.folder.write(".cache/steps.jsonl", text);
        EXPECT_FALSE(Ledger(made.folder.path()).finished("a", 7)) << text;
    }
}

TEST(Ledger, RemovesWhatAStepNoLongerMakes) {
    const FinishedStep made;
    made.folder.write("two.png", "1");
    Ledger(made.folder.path()).record("a", record_with(8, {"two.png"}));
    EXPECT_FALSE(fs::exists(made.folder / "one.png"));
    EXPECT_TRUE(fs::exists(made.folder / "two.png"));
}

TEST(Ledger, RemovesNothingOutsideTheFolder) {
    const test::TemporaryFolder outside;
    const fs::path precious = outside.write("precious", "1");
    const FinishedStep made;
    for (const fs::path& path : {precious, fs::relative(precious, made.folder.path())}) {
        const Json lie = {{"step", "a"},
                          {"key", 7},
                          {"outputs", {path.string()}},
                          {"sizes", {1}},
                          {"result", Json::object()},
                          {"seconds", 1.0},
                          {"peak_memory", 1},
                          {"hashes", {1}},
                          {"written", {1}}};
        made.folder.write(".cache/steps.jsonl", lie.dump() + "\n");
        ASSERT_TRUE(Ledger(made.folder.path()).has("a"));
        Ledger(made.folder.path()).record("a", record_with(9, {}));
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
    first.record("b", record_with(1, {"two.png"}));
    second.record("c", record_with(2, {"three.png"}));
    Ledger again(folder.path());
    again.record_apart("first");
    again.record("d", record_with(3, {"four.png"}));

    Ledger all(folder.path());
    const auto expect_all = [](const Ledger& ledger) {
        EXPECT_TRUE(ledger.finished("a", 7));
        EXPECT_TRUE(ledger.finished("b", 1));
        EXPECT_TRUE(ledger.finished("c", 2));
        EXPECT_TRUE(ledger.finished("d", 3));
    };
    expect_all(all);
    all.record("a", record_with(7, {"one.png"}));
    EXPECT_TRUE(fs::is_empty(folder / ".cache/steps"));
    expect_all(Ledger(folder.path()));
}

TEST(Ledger, OfAStepThatSeveralMadeTheLastCounts) {
    const FinishedStep made;
    for (const auto& [name, key] : {std::pair{"z", 1u}, {"a", 2u}}) {
        Ledger ledger(made.folder.path());
        ledger.record_apart(name);
        ledger.record("b", record_with(key, {"one.png"}));
        const auto file = made.folder / (".cache/steps/" + std::string(name) + ".jsonl");
        fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(key));
    }
    EXPECT_TRUE(Ledger(made.folder.path()).finished("b", 2));
    made.folder.write(".cache/steps/y.jsonl", "{ damaged");
    EXPECT_TRUE(Ledger(made.folder.path()).finished("b", 2));
}

// A film has tens of thousands of records.
TEST(Ledger, WritesNoMoreThanEachRecordOnce) {
    const std::uint64_t few = bytes_of_recording(100);
    if (few == 0) GTEST_SKIP() << "this system does not count what is written";
    EXPECT_NEAR(double(bytes_of_recording(800)), 8.0 * double(few), 0.05 * double(few));
}

// A run that is killed while it writes a record loses this one only, and the next run
// goes on behind what is left.
TEST(Ledger, ARecordCutShortAnywhereLosesOnlyItself) {
    const FinishedStep made;
    const auto file = made.folder / ".cache/steps.jsonl";
    const std::string before = read_text(file);
    Ledger(made.folder.path()).record("b", record_with(2, {}));
    const std::string whole = read_text(file);
    ASSERT_TRUE(whole.starts_with(before));
    for (std::size_t size = before.size(); size <= whole.size(); ++size) {
        write_text(file, whole.substr(0, size));
        {
            Ledger ledger(made.folder.path());
            EXPECT_TRUE(ledger.finished("a", 7)) << size;
            // All of it is there but the end of the line.
            EXPECT_EQ(ledger.has("b"), size + 1 >= whole.size()) << size;
            ledger.record("c", record_with(3, {}));
        }
        const Ledger again(made.folder.path());
        EXPECT_TRUE(again.finished("a", 7)) << size;
        EXPECT_EQ(again.has("b"), size + 1 >= whole.size()) << size;
        EXPECT_TRUE(again.finished("c", 3)) << size;
    }
}

// The same of a process that has its own file.
TEST(Ledger, ARecordApartThatIsCutShortLosesOnlyItself) {
    const FinishedStep made;
    const auto file = made.folder / ".cache/steps/own.jsonl";
    for (const char* step : {"b", "c"}) {
        Ledger ledger(made.folder.path());
        ledger.record_apart("own");
        ledger.record(step, record_with(2, {}));
    }
    const std::string whole = read_text(file);
    write_text(file, whole.substr(0, whole.size() - 9));
    {
        Ledger ledger(made.folder.path());
        ledger.record_apart("own");
        ledger.record("d", record_with(3, {}));
    }
    const Ledger ledger(made.folder.path());
    for (const char* step : {"a", "b", "d"}) EXPECT_TRUE(ledger.has(step)) << step;
    EXPECT_FALSE(ledger.has("c"));
}

TEST(Ledger, IsWrittenAnewWhenMostOfItIsStale) {
    const FinishedStep made;
    const auto size = [&] { return fs::file_size(made.folder / ".cache/steps.jsonl"); };
    {
        Ledger ledger(made.folder.path());
        for (std::uint64_t key = 0; key < 200; ++key)
            ledger.record("b", record_with(key, {}));
    }
    const auto worn = size();
    Ledger(made.folder.path()).record("c", record_with(3, {}));
    EXPECT_LT(size(), worn / 20);
    const Ledger ledger(made.folder.path());
    EXPECT_TRUE(ledger.finished("a", 7));
    EXPECT_TRUE(ledger.finished("b", 199));
    EXPECT_TRUE(ledger.finished("c", 3));
}

TEST(Ledger, AStepThatWroteOneFileTwiceIsRefused) {
    const FinishedStep made;
    EXPECT_THROW(
        Ledger(made.folder.path()).record("b", record_with(1, {"one.png", "one.png"})),
        Error);
}
