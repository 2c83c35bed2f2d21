// What is handed in to a farm, with programs in the place of Slurm's that note down how
// they were called. tests/e2e/farm_test.cpp has the real ones.
#include "app/farm/farm.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "app/farm/scripts.h"
#include "field/files.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

// What a script does with `task` as its array task's number, in place of Slurm.
int run_script(const fs::path& script, const std::string& task,
               const std::string& restarts = "0") {
    const std::string command = "SLURM_JOB_ID=77 SLURM_ARRAY_TASK_ID=" + task +
                                " SLURM_RESTART_COUNT=" + restarts + " bash " +
                                quoted(script.string()) + " > /dev/null 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
}

struct Farm : testing::Test {
    TemporaryFolder folder;
    fs::path bin = folder / "bin";
    Farm() {
        folder.write("land.toml", kSmallScene);
        fs::create_directories(bin);
    }

    // sbatch that gives 101, 102 ... and refuses `refused`; and a queue that holds
    // `queue`.
    void put_slurm(const std::string& refused = "none", const std::string& queue = "") {
        const std::string log = quoted((folder / "calls").string());
        folder.write_script(
            "bin/sbatch", "for last; do :; done\necho sbatch \"$PWD\" \"$@\" >> " + log +
                              "\n[ \"$last\" = " + refused +
                              " ] && { echo 'Requested node configuration is not "
                              "available'; exit 1; }\n"
                              "echo \"$((100 + $(grep -c ^sbatch " +
                              log + ")));here\"");
        folder.write_script("bin/scancel", "echo scancel \"$@\" >> " + log);
        folder.write_script("bin/squeue", "printf '" + queue + "'");
    }
    std::string calls() const {
        std::error_code none;
        return fs::exists(folder / "calls", none) ? read_text(folder / "calls") : "";
    }
    Outcome ask(std::vector<std::string> more,
                const std::string& after = ":/usr/bin:/bin") const {
        more.insert(more.begin(), "farm");
        Start start{folder.path()};
        start.environment["PATH"] = bin.string() + after;
        return run(start, more);
    }
    void expect_refused(const Outcome& outcome, int code,
                        const std::string& words) const {
        EXPECT_EQ(outcome.code, code) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }
};

const std::vector<std::string> kTurntable = {"land.toml", "--frames", "0-9", "--quality",
                                             "draft",     "--chunk",  "4"};

}  // namespace

TEST(FarmScripts, AnyWordReachesTheProgramAsItIs) {
    const TemporaryFolder folder;
    folder.write_script("a $(touch x) 'program'",
                        "printf '%s\\n' \"$@\" > " + quoted((folder / "words").string()));
    FarmPlan plan;
    plan.program = folder / "a $(touch x) 'program'";
    plan.folder = folder.path();
    plan.name = "land";
    plan.goal = Goal::kFilm;
    plan.request.scene = "/a b/`touch y`/it's \"one\".toml";
    plan.request.output = "/out/$HOME;\n#SBATCH --uid=0";
    plan.request.overrides = {"title='a \\ b'", "x=$(touch z)"};
    plan.request.size = {{64, 36}};
    plan.chunks = {{0, 3}, {4, 4}, {10, 12}};
    const std::vector<Script> scripts = scripts_of(plan);
    ASSERT_EQ(scripts.size(), 3u);
    EXPECT_EQ(scripts[1].file, "frames.sh");
    folder.write("frames.sh", scripts[1].text);
    EXPECT_EQ(run_script(folder / "frames.sh", "2"), 0);
    EXPECT_EQ(read_text(folder / "words"),
              "film\n/a b/`touch y`/it's \"one\".toml\n-o\n"
              "/out/$HOME;\n#SBATCH --uid=0\n--quality\npreview\n"
              "--set\ntitle='a \\ b'\n--set\nx=$(touch z)\n--size\n64x36\n"
              "--threads\n1\n--trace-only\n--frames\n10-12\n");
    for (const char* touched : {"x", "y", "z"})
        EXPECT_FALSE(fs::exists(folder / touched));
    // Slurm reads directives up to the first command: none of ours comes after.
    const std::string& text = scripts[1].text;
    EXPECT_LT(text.rfind("#SBATCH --array=0-2"), text.find("\ncd "));
}

TEST(FarmScripts, WhatFailsIsTriedThreeTimesAndWhatIsWrongOnce) {
    const TemporaryFolder folder;
    const std::string log = quoted((folder / "requeued").string());
    folder.write_script("bin/scontrol", "echo \"$@\" >> " + log);
    folder.write_script("bin/sleep", "");
    FarmPlan plan;
    plan.program = folder / "program";
    plan.folder = folder.path();
    plan.chunks = {{0, 0}};
    folder.write("frames.sh", "PATH=" + (folder / "bin").string() + ":$PATH\n" +
                                  scripts_of(plan)[1].text);
    const auto requeued = [&](int code, const std::string& restarts) {
        folder.write_script("program", "exit " + std::to_string(code));
        fs::remove(folder / "requeued");
        EXPECT_EQ(run_script(folder / "frames.sh", "0", restarts), code);
        return fs::exists(folder / "requeued");
    };
    EXPECT_TRUE(requeued(1, "0"));
    EXPECT_EQ(read_text(folder / "requeued"), "requeue 77\n");
    EXPECT_TRUE(requeued(1, "1"));
    EXPECT_FALSE(requeued(1, "2"));
    EXPECT_TRUE(requeued(137, "0")) << "killed for want of memory";
    EXPECT_FALSE(requeued(2, "0")) << "the scene is wrong: it is so anywhere";
    EXPECT_FALSE(requeued(0, "0"));
}

TEST_F(Farm, HandsInTheLandThenTheFramesThenTheRest) {
    put_slurm();
    const Outcome outcome = ask(kTurntable);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string in = (fs::canonical(folder.path()) / "out/land/farm").string();
    EXPECT_EQ(calls(), "sbatch " + in + " --parsable land.sh\n" +  //
                           "sbatch " + in +
                           " --parsable --dependency=afterok:101 "
                           "--kill-on-invalid-dep=yes frames.sh\n" +
                           "sbatch " + in +
                           " --parsable --dependency=afterok:102 "
                           "--kill-on-invalid-dep=yes collect.sh\n");
    const std::string frames = read_text(folder / "out/land/farm/frames.sh");
    EXPECT_NE(frames.find("\nframes=(0-3 4-7 8-9)\n"), std::string::npos) << frames;
    EXPECT_NE(frames.find("#SBATCH --array=0-2\n"), std::string::npos) << frames;
    EXPECT_NE(frames.find("'frames.count=10'"), std::string::npos) << frames;
    EXPECT_EQ(
        std::system(("bash -n " + (folder / "out/land/farm/land.sh").string()).c_str()),
        0);
    // What was handed in and is still queued is not handed in again.
    put_slurm("none", "102_0|RUNNING|n1|None\\n102_[1-2]|PENDING||Resources\\n");
    expect_refused(ask(kTurntable), 2, "still queued");
    const Outcome status = ask({"status", "land.toml"});
    EXPECT_NE(status.out.find("frames   job 102      runs on n1; 1 waiting (Resources)"),
              std::string::npos)
        << status.out << status.err;
    EXPECT_NE(status.out.find("frames still to be traced: 10\n"), std::string::npos)
        << status.out;
    expect_refused(ask({"collect", "land.toml"}), 1, "10 frames are not traced");
    put_slurm("none", "102_0|TIMEOUT|n1|TimeLimit\\n");
    EXPECT_NE(ask({"status", "land.toml"}).out.find("1 failed: 102_0 (TIMEOUT)"),
              std::string::npos);
}

TEST_F(Farm, ADryRunPrintsTheScriptsAndWritesNothing) {
    auto dry = kTurntable;
    dry.push_back("--dry-run");
    const Outcome outcome = ask(dry);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    for (const char* words : {"land.sh", "frames.sh", "collect.sh", "#SBATCH --mem=",
                              "#SBATCH --time=0-00:20:00", "farm collect"})
        EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
    EXPECT_FALSE(fs::exists(folder / "out/land/farm"));
}

TEST_F(Farm, MemoryIsPredictedFromTheScene) {
    const auto memory = [&](const std::string& samples) {
        const Outcome outcome =
            ask({"land.toml", "--dry-run", "--set", "terrain.samples=" + samples});
        const std::string key = "#SBATCH --mem=";
        const auto frames = outcome.out.find("frames.sh");
        return std::stoi(outcome.out.substr(outcome.out.find(key, frames) + key.size()));
    };
    EXPECT_GT(memory("2048"), 2 * memory("64"));
}

TEST_F(Farm, WhatSlurmRefusesIsSaidAndTakenBack) {
    expect_refused(ask(kTurntable, ""), 1, "no sbatch on the PATH");
    put_slurm("collect.sh");
    const Outcome outcome = ask(kTurntable);
    expect_refused(outcome, 1, "Requested node configuration is not available");
    expect_refused(outcome, 1, "SBATCH_PARTITION");
    EXPECT_TRUE(calls().ends_with("scancel 101 102\n")) << calls();
    expect_refused(ask({"status", "land.toml"}), 2, "no jobs were submitted");
    folder.write_script("bin/sbatch", "echo Welcome");
    expect_refused(ask(kTurntable), 1, "sbatch gave no job id: Welcome");
}

TEST_F(Farm, BadInput) {
    put_slurm();
    expect_refused(ask({}), 2, "SCENE");
    expect_refused(ask({"land.toml", "--frames", "9-0"}), 2, "--frames");
    expect_refused(ask({"land.toml", "--frames", "0-99999"}), 2, "--frames");
    expect_refused(ask({"land.toml", "--chunk", "0"}), 2, "--chunk");
    expect_refused(ask({"land.toml", "--frames", "9-12", "--set", "frames.count=12"}), 2,
                   "the turntable has 12 frames, 0 to 11");
    expect_refused(ask({"land.toml", "--sequence", "film"}), 2, "nothing to film");
    expect_refused(ask({"status", "land.toml"}), 2, "no jobs were submitted");
    folder.write("out/land/farm/farm.json", "{\"command\": 1}");
    expect_refused(ask({"status", "land.toml"}), 2, "damaged");
    EXPECT_EQ(calls(), "");
}
