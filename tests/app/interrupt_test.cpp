// Ctrl-C, and a POV-Ray that is missing, fails or dies: nothing half-written, and the
// same command goes on afterwards.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia::test;

namespace {

struct Interrupt : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/land";
    Interrupt() { folder.write("land.toml", kSmallScene); }

    // Our own `povray` first on the search path.
    Start with_povray(const std::string& script) const {
        folder.write_script("bin/povray", script);
        return {folder.path(),
                {{"PATH", (folder / "bin").string() + ":" + getenv("PATH")}}};
    }
    Outcome render(const Start& start) const {
        return run(start, {"render", "land.toml", "--quality", "draft"});
    }
    void expect_goes_on() const {
        const Outcome outcome = render({folder.path()});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_TRUE(fs::exists(out / "frames/overhead.png"));
    }
    void expect_no_frame() const {
        EXPECT_EQ(files_below(out / "frames"), std::vector<std::string>{});
        EXPECT_FALSE(fs::exists(out / "pov/overhead.exr"));
        EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
    }
};

int line_count(const std::string& text, const std::string& word) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at)
        ++count;
    return count;
}

}  // namespace

TEST_F(Interrupt, DuringSynthesis) {
    const std::string scene =
        kSmallScene +
        "[[terrain.stage]]\nmethod = \"distance\"\n[[terrain.stage.group]]\npeaks = { "
        "count = 40 }\n";
    folder.write("land.toml", scene);
    const std::vector<std::string> synth = {"synth", "land.toml", "--set",
                                            "terrain.samples=1024"};
    const auto first_stage_done = [&] { return fs::exists(out / ".cache/steps.jsonl"); };
    for (int signal : {SIGINT, SIGTERM}) {
        fs::remove_all(out);
        const Outcome outcome =
            run_and_signal({folder.path()}, synth, signal, first_stage_done);
        EXPECT_EQ(outcome.signal, signal);
        EXPECT_EQ(line_count(outcome.err, "interrupted"), 1) << outcome.err;
        EXPECT_FALSE(fs::exists(out / "terrain.exr"));
        EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});

        std::vector<std::string> plan = synth;
        plan.push_back("--dry-run");
        const std::string text = run({folder.path()}, plan).out;
        EXPECT_EQ(line_count(text, "done"), 1) << text;
    }
}

TEST_F(Interrupt, DuringPovray) {
    const fs::path started = folder / "started";
    const Start start =
        with_povray("echo $$ > " + started.string() + "; exec sleep 1000");
    const Outcome outcome =
        run_and_signal(start, {"render", "land.toml", "--quality", "draft"}, SIGINT,
                       [&] { return fs::exists(started) && fs::file_size(started) > 0; });
    EXPECT_EQ(outcome.signal, SIGINT);
    EXPECT_EQ(line_count(outcome.err, "interrupted"), 1) << outcome.err;
    pid_t povray = 0;
    std::ifstream(started) >> povray;
    ASSERT_GT(povray, 0);
    EXPECT_NE(kill(povray, 0), 0) << "POV-Ray outlived the program";
    expect_no_frame();
    expect_goes_on();
}

TEST_F(Interrupt, NoPovrayOnThePath) {
    const Outcome outcome = render({folder.path(), {{"PATH", folder.path().string()}}});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("povray"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(out)) << "said before any work begins";
}

TEST_F(Interrupt, PovrayFails) {
    const Outcome outcome =
        render(with_povray("echo 'Parse Error: the moon is missing' >&2; exit 1"));
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("the moon is missing"), std::string::npos) << outcome.err;
    expect_no_frame();
    expect_goes_on();
}

// Half a picture where POV-Ray was told to write it.
const std::string kHalfAPicture =
    "for a; do case $a in +O*) echo half >\"${a#+O}\";; esac; done; ";

TEST_F(Interrupt, PovrayIsKilledMidway) {
    const Outcome outcome = render(with_povray(kHalfAPicture + "kill -KILL $$"));
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("killed"), std::string::npos) << outcome.err;
    expect_no_frame();
    expect_goes_on();
}

TEST_F(Interrupt, PovrayWritesHalfAPicture) {
    const Outcome outcome = render(with_povray(kHalfAPicture + "exit 0"));
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    expect_no_frame();
    expect_goes_on();
}

TEST_F(Interrupt, PovrayWritesNothing) {
    EXPECT_EQ(render(with_povray("exit 0")).code, 1);
    expect_no_frame();
    expect_goes_on();
}
