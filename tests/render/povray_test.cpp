#include "render/frames/povray.h"

#include <gtest/gtest.h>
#include <sys/mount.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "field/image.h"
#include "tests/field/temporary_folder.h"
#include "tests/render/environment.h"
#include "tests/render/no_povray.h"

namespace cydonia::render {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

// What a run reported; interrupts once it has seen `interrupt_at`.
class Watcher final : public Progress {
  public:
    explicit Watcher(double interrupt_at = 2.0) : interrupt_at_(interrupt_at) {}
    void step(std::string_view) override {}
    void report(double fraction) override {
        fractions.push_back(fraction);
        if (fraction >= interrupt_at_) throw Interrupted{};
    }
    void note(std::string_view) override {}
    void warn(std::string_view) override {}

    std::vector<double> fractions;

  private:
    double interrupt_at_;
};

// A shell script in POV-Ray's place, first on the PATH.
class Povray : public testing::Test {
  protected:
    void povray_is(const std::string& script) {
        const fs::path program = programs.with("povray", "#!/bin/sh\n" + script);
        fs::permissions(program, fs::perms::owner_all);
    }
    void run(Progress& progress, seconds limit = seconds(60)) {
        run_povray(folder.path(), "view", 2, limit, progress);
    }
    void expect_failure(std::string_view words, seconds limit = seconds(60)) {
        Watcher watcher;
        expect_error(ExitCode::kFailed, words, [&] { run(watcher, limit); });
        EXPECT_TRUE(folder.is_empty());
    }
    // The script wrote a process number, and nothing runs under it any more; who adopts
    // an orphan may be slow to bury it.
    void expect_gone(const fs::path& number) {
        const fs::path stat = fs::path("/proc") / read_text(number) / "stat";
        const auto runs = [&] {
            std::ifstream in(stat);
            std::string process, name, state;
            return in >> process >> name >> state && state != "Z";
        };
        for (int i = 0; i < 50 && runs(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        EXPECT_FALSE(runs()) << stat;
    }

    TemporaryFolder folder, programs;
    Environment path{"PATH",
                     (programs.path().string() + ":" + std::getenv("PATH")).c_str()};
};

TEST_F(Povray, IsMissing) {
    for (const char* empty : {"", ":::", "/dev/null:/nonexistent"}) {
        const Environment none("PATH", empty);
        expect_error(ExitCode::kFailed, "apt install povray povray-includes",
                     [] { povray_program(); });
        expect_failure("apt install povray povray-includes");
    }
    const Environment none("PATH", nullptr);
    expect_failure("apt install povray povray-includes");
}

TEST_F(Povray, OnThePathButNotExecutableIsPassedOver) {
    const fs::path program = programs.with("povray", "#!/bin/sh\n");
    const Environment only("PATH", programs.path().c_str());
    expect_failure("no povray on the PATH");
    fs::permissions(program, fs::perms::owner_all);
    EXPECT_EQ(povray_program(), program);
}

TEST_F(Povray, CannotBeStarted) {
    const fs::path program = programs.with("povray", "#!/no/such/interpreter\n");
    fs::permissions(program, fs::perms::owner_all);
    expect_failure("cannot start POV-Ray");
}

TEST_F(Povray, RunsInItsFolderAndIsRenamedWhenWhole) {
    povray_is(
        "pwd > where; echo \"$@\" > words; cat > input\n"
        "test -e view.exr && exit 1\n"
        "echo picture > view.part.exr; echo state > view.part.pov-state");
    Watcher watcher;
    run(watcher);
    EXPECT_EQ(read_text(folder / "view.exr"), "picture\n");
    EXPECT_EQ(read_text(folder / "where"), fs::canonical(folder.path()).string() + "\n");
    EXPECT_EQ(read_text(folder / "words"),
              "./view.ini +FE +Oview.part.exr +WT2 +V -D -P\n");
    EXPECT_EQ(read_text(folder / "input"), "");
    EXPECT_FALSE(fs::exists(folder / "view.part.exr"));
    EXPECT_FALSE(fs::exists(folder / "view.part.pov-state"));
    EXPECT_EQ(watcher.fractions.back(), 1.0);
}

TEST_F(Povray, TellsHowFarItIs) {
    povray_is(
        "printf 'Rendered 25 of 100 pixels (25%%)\\rRendered 50 of 100 pix' >&2\n"
        "sleep 0.3; printf 'els (50%%)\\rRendered 20 of 100 pixels (20%%)\\r' >&2\n"
        "sleep 0.3; echo picture > view.part.exr");
    Watcher watcher;
    run(watcher);
    const std::vector<double>& seen = watcher.fractions;
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    for (const double fraction : {0.25, 0.5, 1.0})
        EXPECT_NE(std::find(seen.begin(), seen.end(), fraction), seen.end()) << fraction;
}

TEST_F(Povray, ParseError) {
    povray_is(
        "echo 'povray: cannot open the user configuration file povray.conf' >&2\n"
        "echo '  Fatal Stream to console.........On' >&2\n"
        "echo \"File 'view.pov' line 5: Parse Error: Expected 'object', undeclared\" "
        ">&2\n"
        "echo \" identifier 'spheer' found instead\" >&2\n"
        "echo 'Fatal error in parser: Cannot parse input.' >&2\n"
        "echo 'Render failed' >&2; echo half > view.part.exr; exit 1");
    expect_failure(
        "view.pov: File 'view.pov' line 5: Parse Error: Expected 'object', undeclared "
        "identifier 'spheer' found instead");
}

TEST_F(Povray, FailsWithoutATypicalError) {
    povray_is("echo one; echo two; echo three; echo four; echo Render failed; exit 3");
    expect_failure("view.pov: two three four");
    povray_is("exit 1");
    expect_failure("view.pov: it did not say why");
}

TEST_F(Povray, TalksEndlessly) {
    povray_is("head -c 3000000 /dev/zero | tr '\\0' x; echo; yes | head -200000; exit 1");
    expect_failure("view.pov: y y y");
}

TEST_F(Povray, WritesHalfAFileAndFails) {
    povray_is("echo half > view.part.exr; echo s > view.part.pov-state; exit 1");
    expect_failure("view.pov");
}

TEST_F(Povray, SaysDoneWithoutAPicture) {
    povray_is("echo 'POV-Ray finished'");
    expect_failure("POV-Ray ended without a picture of");
}

TEST_F(Povray, IsKilled) {
    povray_is("echo half > view.part.exr; kill -KILL $$");
    expect_failure("killed by signal 9 (Killed)");
    povray_is("echo half > view.part.exr; kill -SEGV $$");
    expect_failure("killed by signal 11");
}

TEST_F(Povray, TakesTooLong) {
    povray_is("printf $$ > " + (programs / "number").string() +
              "; echo half > view.part.exr; sleep 100; exit 0");
    const auto begin = std::chrono::steady_clock::now();
    expect_failure("took longer than 1 s", seconds(1));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds(5));
    expect_gone(programs / "number");
}

TEST_F(Povray, IsInterrupted) {
    povray_is("echo half > view.part.exr; sleep 100 & printf $! > " +
              (programs / "number").string() +
              "; printf 'Rendered 1 of 2 pixels (50%%)\\r' >&2; wait");
    Watcher watcher(0.5);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_THROW(run(watcher), Interrupted);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds(5));
    EXPECT_TRUE(folder.is_empty());
    expect_gone(programs / "number");
}

// Ctrl-C while POV-Ray is busy and says nothing.
TEST_F(Povray, IsInterruptedInSilence) {
    povray_is("exec >&- 2>&-; sleep 100");
    Watcher watcher(0.0);
    EXPECT_THROW(run(watcher), Interrupted);
    EXPECT_TRUE(folder.is_empty());
}

TEST_F(Povray, LeavesAServantThatHoldsThePipe) {
    povray_is("echo picture > view.part.exr; sleep 100 & exit 0");
    Watcher watcher;
    const auto begin = std::chrono::steady_clock::now();
    run(watcher);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds(5));
    EXPECT_TRUE(fs::exists(folder / "view.exr"));
}

TEST_F(Povray, AnEarlierPictureSurvivesAFailure) {
    folder.with("view.exr", "earlier");
    povray_is("exit 1");
    Watcher watcher;
    EXPECT_THROW(run(watcher), Error);
    EXPECT_EQ(read_text(folder / "view.exr"), "earlier");
}

TEST_F(Povray, FailsOnAFullDisk) {
    const fs::path disk = folder.path() / "disk";
    fs::create_directory(disk);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=512k") != 0)
        GTEST_SKIP() << "needs the right to mount a small disk";
    povray_is("kill -6 $$");
    Watcher watcher;
    expect_error(ExitCode::kFailed, "is full: make space",
                 [&] { run_povray(disk, "view", 2, seconds(60), watcher); });
    EXPECT_EQ(umount(disk.c_str()), 0);
}

TEST_F(Povray, TheRealOneDrawsASphere) {
    if (const auto missing = no_povray()) GTEST_SKIP() << *missing;
    folder.with("view.ini", "Input_File_Name=view.pov\nWidth=64\nHeight=48\n");
    folder.with("view.pov",
                "#version 3.7; global_settings { assumed_gamma 1 }\n"
                "camera { orthographic location -5*z look_at 0 up 2*y right 8/3*x }\n"
                "sphere { 0, 0.5 pigment { rgb <2, 0.5, 0.25> } finish { ambient 0 "
                "diffuse 0 emission 1 } }\n");
    Watcher watcher;
    run(watcher);
    const Field<Rgb> picture = read_exr_rgb(folder / "view.exr");
    EXPECT_EQ(picture.width(), 64);
    EXPECT_EQ(picture.height(), 48);
    EXPECT_EQ(picture(32, 24), (Rgb{2.0f, 0.5f, 0.25f}));
    EXPECT_EQ(picture(2, 2), (Rgb{0, 0, 0}));
    for (const auto& file : fs::directory_iterator(folder.path()))
        EXPECT_EQ(file.path().stem(), "view") << file.path();
}

TEST_F(Povray, TheRealOneNamesTheLine) {
    if (const auto missing = no_povray()) GTEST_SKIP() << *missing;
    folder.with("view.ini", "Input_File_Name=view.pov\n");
    folder.with("view.pov", "#version 3.7;\nspheer { 0, 1 }\n");
    Watcher watcher;
    expect_error(ExitCode::kFailed, "view.pov' line 2: Parse Error",
                 [&] { run(watcher); });
    EXPECT_FALSE(fs::exists(folder / "view.exr"));
}

}  // namespace
}  // namespace cydonia::render
