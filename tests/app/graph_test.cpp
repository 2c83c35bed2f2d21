// Steps, their order, and which of them are done again.
#include "app/pipeline/graph.h"

#include <gtest/gtest.h>

#include "field/error.h"
#include "field/files.h"
#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;

namespace {

using Ids = std::vector<std::string>;

Step step(const std::string& id, std::vector<Need> needs = {}) {
    return {.id = id,
            .needs = std::move(needs),
            .key = [id] { return KeyBuilder(id).key(); },
            .run = [](Graph&) { return StepResult{}; }};
}

Ids ids_of(const std::vector<const Step*>& steps) {
    Ids ids;
    for (const Step* step : steps) ids.push_back(step->id);
    return ids;
}

Ids ids_of(const std::vector<Step>& steps) {
    Ids ids;
    for (const Step& step : steps) ids.push_back(step.id);
    return ids;
}

struct GraphTest : testing::Test {
    test::TemporaryFolder folder;
    Ledger ledger{folder.path()};
    Ids ran;
    std::map<std::string, int> keys_asked;

    // Writes `text` into a file that is called after the step.
    Step writing(const std::string& id, const std::string& key, const std::string& text,
                 std::vector<Need> needs = {}) {
        return {.id = id,
                .needs = std::move(needs),
                .key =
                    [this, id, key] {
                        ++keys_asked[id];
                        return KeyBuilder(key).key();
                    },
                .run =
                    [this, id, text](Graph&) {
                        ran.push_back(id);
                        write_text(folder / id, text);
                        return StepResult{{id}};
                    }};
    }
    // What a run of these steps did.
    Ids run(std::vector<Step> steps) {
        ran.clear();
        Graph graph(std::move(steps), ledger);
        for (const Step& each : graph.steps()) graph.finish(each);
        return ran;
    }
};

}  // namespace

TEST_F(GraphTest, StepsStandBehindWhatTheyNeedAndOtherwiseAsGiven) {
    const Graph graph({step("d", {{"b"}, {"c", Use::kShown}}), step("a"), step("c"),
                       step("b", {{"a", Use::kDone}})},
                      ledger);
    EXPECT_EQ(ids_of(graph.steps()), (Ids{"a", "c", "b", "d"}));
}

TEST_F(GraphTest, MistakesInTheTableAreNamed) {
    EXPECT_THROW(Graph({step("a"), step("a")}, ledger), std::logic_error);
    EXPECT_THROW(Graph({step("a", {{"b"}})}, ledger), std::logic_error);
    EXPECT_THROW(Graph({step("a", {{"b"}}), step("b", {{"a"}})}, ledger),
                 std::logic_error);
    EXPECT_THROW(Graph({step("a", {{"a"}})}, ledger), std::logic_error);
}

TEST_F(GraphTest, AClosureHasWhatMustBeDoneAndNothingElse) {
    const Graph graph(
        {step("a"), step("b", {{"a", Use::kFiles}}), step("c", {{"a", Use::kDone}}),
         step("d", {{"b"}}), step("page", {{"c", Use::kShown}, {"d", Use::kShown}})},
        ledger);
    EXPECT_EQ(ids_of(graph.closure({"d"})), (Ids{"a", "b", "d"}));
    EXPECT_EQ(ids_of(graph.closure({"page", "c"})), (Ids{"a", "c", "page"}));
    EXPECT_EQ(ids_of(graph.closure({})), Ids{});
}

TEST_F(GraphTest, NothingIsDoneTwice) {
    const auto steps = [&] {
        return std::vector{writing("a", "1", "x"), writing("b", "1", "y", {{"a"}})};
    };
    EXPECT_EQ(run(steps()), (Ids{"a", "b"}));
    EXPECT_EQ(run(steps()), Ids{});
    fs::remove(folder / "b");
    EXPECT_EQ(run(steps()), Ids{"b"});
}

TEST_F(GraphTest, WhatIsMadeFromAllOfAnotherFollowsItsKey) {
    const auto steps = [&](const std::string& key) {
        return std::vector{writing("a", key, "x"), writing("b", "1", "y", {{"a"}}),
                           writing("c", "1", "z", {{"b"}})};
    };
    run(steps("1"));
    EXPECT_EQ(run(steps("2")), (Ids{"a", "b", "c"}));
}

TEST_F(GraphTest, WhatIsMadeFromFilesFollowsTheirBytes) {
    const auto steps = [&](const std::string& key, const std::string& text) {
        return std::vector{writing("a", key, text),
                           writing("b", "1", "y", {{"a", Use::kFiles}})};
    };
    run(steps("1", "x"));
    EXPECT_EQ(run(steps("2", "x")), Ids{"a"});
    EXPECT_EQ(run(steps("3", "other")), (Ids{"a", "b"}));
}

TEST_F(GraphTest, WhatOnlyComesAfterAnotherIsNotMadeFromIt) {
    const auto steps = [&](const std::string& key) {
        return std::vector{writing("a", key, "x"),
                           writing("b", "1", "y", {{"a", Use::kDone}})};
    };
    run(steps("1"));
    EXPECT_EQ(run(steps("2")), Ids{"a"});
}

TEST_F(GraphTest, AStepIsFinishedWithAllThatItNeeds) {
    const auto steps = [&](const std::string& key) {
        return std::vector{writing("a", key, "x"),
                           writing("b", "1", "y", {{"a", Use::kDone}})};
    };
    run(steps("1"));
    Graph same(steps("1"), ledger), other(steps("2"), ledger);
    EXPECT_TRUE(same.finished("b"));
    EXPECT_FALSE(other.finished("b"));
}

TEST_F(GraphTest, WhatIsShownCountsWhereItIsFinished) {
    const auto steps = [&](const std::string& key) {
        return std::vector{
            writing("a", key, "x"), writing("b", "1", "y"),
            writing("page", "1", "p", {{"a", Use::kShown}, {"b", Use::kShown}})};
    };
    const auto page = [&](const std::string& key) {
        ran.clear();
        Graph graph(steps(key), ledger);
        graph.finish(graph.step("page"));
        return ran;
    };
    EXPECT_EQ(page("1"), Ids{"page"});
    EXPECT_EQ(page("1"), Ids{});
    EXPECT_EQ(run(steps("1")), (Ids{"a", "b", "page"}));
    EXPECT_EQ(page("1"), Ids{});
    EXPECT_EQ(page("2"), Ids{"page"}) << "a is not finished any more";
}

TEST_F(GraphTest, AKeyIsAskedOnceAndOfNoStepThatNeverRan) {
    const auto steps = [&] {
        return std::vector{writing("a", "1", "x"), writing("b", "1", "y", {{"a"}})};
    };
    Graph first(steps(), ledger);
    EXPECT_FALSE(first.finished("b"));
    EXPECT_TRUE(keys_asked.empty());
    run(steps());
    keys_asked.clear();
    Graph graph(steps(), ledger);
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(graph.finished("b"));
        graph.finish(graph.step("b"));
        graph.forget();
    }
    EXPECT_EQ(keys_asked, (std::map<std::string, int>{{"a", 1}, {"b", 1}}));
}

TEST_F(GraphTest, StepsNeedThoseOfTheGraphBelow) {
    Graph below({writing("a", "1", "x")}, ledger);
    const auto above = [&] { return std::vector{writing("b", "1", "y", {{"a"}})}; };
    {
        Graph graph(above(), ledger, &below);
        EXPECT_THROW(graph.finish(graph.step("b")), std::logic_error) << "a is not done";
        below.finish(below.step("a"));
        graph.finish(graph.step("b"));
    }
    Graph again(above(), ledger, &below);
    EXPECT_TRUE(again.finished("b"));
    Graph other({writing("a", "2", "x")}, ledger);
    Graph on_other(above(), ledger, &other);
    EXPECT_FALSE(on_other.finished("b"));
}

TEST_F(GraphTest, EqualOutputsAreRefusedWithBothNames) {
    const auto writer = [](const std::string& id, const Ids& files) {
        Step made = step(id);
        made.writes = [files] { return files; };
        return made;
    };
    const Step a = writer("a", {"x", "y"}), b = writer("b", {"z"}),
               c = writer("c", {"w", "y"});
    EXPECT_NO_THROW(refuse_equal_outputs({&a, &b}));
    try {
        refuse_equal_outputs({&a, &b, &c});
        FAIL() << "a and c both write y";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadRequest);
        const std::string message = error.what();
        for (const char* word : {"y would be", "'a'", "'c'"})
            EXPECT_NE(message.find(word), std::string::npos) << message;
    }
}
