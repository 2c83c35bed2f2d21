// A film on a farm: Slurm's own daemons on this machine, one of whose two nodes dies.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "app/farm/scripts.h"
#include "field/files.h"
#include "field/image.h"
#include "render/frames/program.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"
#include "tests/render/no_povray.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

std::optional<std::string> no_slurm() {
    if (geteuid() != 0) return "Slurm's daemons are started as root only";
    for (const char* program : {"slurmctld", "slurmd", "munged", "sbatch"})
        if (!render::program_on_path(program))
            return fmt::format("no {}: packages slurm-wlm and munge", program);
    return std::nullopt;
}

// Ended with the test.
class Cluster {
  public:
    explicit Cluster(const fs::path& folder) : folder_(folder) {
        ready_ = ask("start");
        setenv("SLURM_CONF", (folder / "slurm.conf").c_str(), 1);
    }
    ~Cluster() {
        ask("stop");
        unsetenv("SLURM_CONF");
    }
    Cluster(const Cluster&) = delete;
    Cluster& operator=(const Cluster&) = delete;
    bool ready() const { return ready_; }
    void kill(const std::string& node) { EXPECT_TRUE(ask("kill", node)); }

  private:
    bool ask(const std::string& what, const std::string& node = "") const {
        const std::string command = quoted(CYDONIA_SOURCE_DIR "/tests/slurm/cluster.sh") +
                                    " " + what + " " + quoted(folder_.string()) + " " +
                                    node + " > /dev/null 2>&1";
        return std::system(command.c_str()) == 0;
    }

    fs::path folder_;
    bool ready_ = false;
};

std::string told(const std::string& command) {
    std::string text;
    FILE* pipe = popen((command + " 2> /dev/null").c_str(), "r");
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        text += static_cast<char>(c);
    pclose(pipe);
    return text;
}

struct FarmFilm : testing::Test {
    TemporaryFolder folder;
    fs::path local = folder / "local", farm = folder / "farm";
    FarmFilm() { folder.write("land.toml", kSmallScene); }

    Outcome ask(const std::string& command, const fs::path& out,
                std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{command, "land.toml", "-o", out.string()};
        const std::vector<std::string> film{"--quality", "draft", "--size",
                                            "96x54",     "--set", "terrain.samples=32"};
        arguments.insert(arguments.end(), film.begin(), film.end());
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run({folder.path()}, arguments);
    }
    std::string status() const {
        return run({folder.path()}, {"farm", "status", "land.toml", "-o", farm.string()})
            .out;
    }
    int recorded() const {
        return std::atoi(
            told("cat " + quoted(farm.string()) +
                 "/.cache/steps/*.jsonl 2> /dev/null | grep -c '\"trace turntable-'")
                .c_str());
    }
    void expect_the_films_equal(int frames) const {
        for (int i = 1; i <= frames; ++i) {
            const std::string name = fmt::format("frames/turntable-{:04}", i);
            EXPECT_EQ(read_rgba(open_source(local / (name + ".png"))),
                      read_rgba(open_source(farm / (name + ".png"))))
                << name;
            EXPECT_EQ(read_exr_rgb(local / (name + ".exr")),
                      read_exr_rgb(farm / (name + ".exr")))
                << name;
        }
        EXPECT_TRUE(fs::exists(farm / "frames/turntable.mp4"));
        EXPECT_TRUE(fs::exists(farm / "report.html"));
    }
};

}  // namespace

// Frames traced by processes beside one another are those of one process, and the next
// run takes them as they are.
TEST_F(FarmFilm, ProcessesBesideOneAnother) {
    if (const auto why = no_povray()) GTEST_SKIP() << *why;
    ASSERT_EQ(ask("turntable", local, {"--frames", "5"}).code, 0);
    const std::vector<std::string> five{"--set", "frames.count=5", "--trace-only"};
    const auto trace = [&](const char* frames) {
        auto more = five;
        more.insert(more.end(), {"--frames", frames});
        return ask("turntable", farm, more);
    };
    const Outcome early = trace("0-2");
    EXPECT_EQ(early.code, 2);
    EXPECT_NE(early.err.find("has to be done first"), std::string::npos) << early.err;

    const std::vector<std::string> land{"emit",        "land.toml",         "-o",
                                        farm.string(), "--quality",         "draft",
                                        "--set",       "terrain.samples=32"};
    ASSERT_EQ(run({folder.path()}, land).code, 0);
    Outcome first, second;
    {
        const std::jthread one([&] { first = trace("0-2"); });
        const std::jthread other([&] { second = trace("3-4"); });
    }
    EXPECT_EQ(first.code, 0) << first.err;
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_FALSE(fs::exists(farm / "frames/turntable-0001.png"));
    const auto traced = fs::last_write_time(farm / "pov/turntable-0002.exr");
    const auto last = fs::last_write_time(farm / "pov/turntable-0005.exr");
    ASSERT_EQ(ask("turntable", farm, {"--frames", "5"}).code, 0);
    EXPECT_EQ(fs::last_write_time(farm / "pov/turntable-0002.exr"), traced);
    EXPECT_EQ(fs::last_write_time(farm / "pov/turntable-0005.exr"), last);
    expect_the_films_equal(5);
}

TEST_F(FarmFilm, SurvivesTheDeathOfANode) {
    if (const auto why = no_povray()) GTEST_SKIP() << *why;
    if (const auto why = no_slurm()) GTEST_SKIP() << *why;
    constexpr int kFrames = 8;
    ASSERT_EQ(ask("turntable", local, {"--frames", "8"}).code, 0);
    Cluster cluster(folder / "slurm");
    ASSERT_TRUE(cluster.ready());
    const Outcome handed_in = ask("farm", farm, {"--frames", "0-7", "--chunk", "1"});
    ASSERT_EQ(handed_in.code, 0) << handed_in.err;

    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(5);
    const auto in_time = [&] { return std::chrono::steady_clock::now() < deadline; };
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(300)); };
    while (recorded() < 2 && in_time()) wait();
    while (told("squeue --noheader --states=running --nodelist=n1").empty() && in_time())
        wait();
    cluster.kill("n1");
    while (!told("squeue --noheader").empty() && in_time()) {
        // Slurm lets what ran on a lost node wait for two minutes.
        told(
            "for job in $(squeue --noheader --array --states=pending --format=%A); do "
            "scontrol update JobId=$job StartTime=now; done");
        wait();
    }
    EXPECT_TRUE(in_time()) << status();
    EXPECT_NE(status().find("frames still to be traced: 0"), std::string::npos)
        << status();
    expect_the_films_equal(kFrames);
}
