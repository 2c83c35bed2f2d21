// What goes wrong outside the program: one clear message, the right exit code, nothing
// half-written.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <csignal>
#include <fstream>

#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia::test;

namespace {

struct BadInput : testing::Test {
    TemporaryFolder folder;
    BadInput() { folder.write("land.toml", kSmallScene); }

    Outcome ask(const std::vector<std::string>& arguments) const {
        return run({folder.path()}, arguments);
    }
    void expect_refused(const Outcome& outcome, int code,
                        const std::string& reason) const {
        EXPECT_EQ(outcome.code, code) << outcome.err;
        EXPECT_NE(("\n" + outcome.err).find("\ncydonia: "), std::string::npos)
            << outcome.err;
        EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
        EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
    }
};

// A file system of a megabyte, where the user may mount one.
class SmallDisk {
  public:
    SmallDisk(const fs::path& path, unsigned long flags) : path_(path) {
        fs::create_directories(path);
        mounted_ = mount("none", path.c_str(), "tmpfs", flags, "size=1m") == 0;
    }
    ~SmallDisk() {
        if (mounted_) umount2(path_.c_str(), MNT_DETACH);
    }
    bool mounted() const { return mounted_; }

  private:
    fs::path path_;
    bool mounted_;
};

}  // namespace

TEST_F(BadInput, MissingScene) {
    for (const char* command : {"render", "synth", "check", "emit", "validate", "info"}) {
        expect_refused(ask({command, "none.toml"}), 2, "none.toml");
    }
}

TEST_F(BadInput, UnknownKeyNamesPlaceAndNearest) {
    folder.write("land.toml", "sed = 3\n" + kSmallScene);
    const Outcome outcome = ask({"render", "land.toml"});
    expect_refused(outcome, 2, "land.toml:1:1:");
    EXPECT_NE(outcome.err.find("seed"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(BadInput, WrongOverride) {
    expect_refused(ask({"synth", "land.toml", "--set", "terrain.sample=8"}), 2,
                   "samples");
    expect_refused(ask({"synth", "land.toml", "--set", "nonsense"}), 2, "nonsense");
}

TEST_F(BadInput, EmptyTarget) {
    folder.write("land.toml", kShadowScene);
    folder.write("bar.svg", "");
    expect_refused(ask({"synth", "land.toml"}), 2, "bar.svg");
}

TEST_F(BadInput, BrokenTargetPng) {
    std::string scene = kShadowScene;
    scene.replace(scene.find("bar.svg"), 7, "bar.png");
    folder.write("land.toml", scene);
    for (const std::string bytes : {"\x89PNG\r\n\x1a\n", "not an image at all"}) {
        folder.write("bar.png", bytes);
        expect_refused(ask({"synth", "land.toml"}), 2, "bar.png");
    }
}

TEST_F(BadInput, TargetWithoutShadow) {
    folder.write("white.svg",
                 R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8"/>)");
    ASSERT_EQ(ask({"synth", "land.toml"}).code, 0);
    expect_refused(ask({"check", "--height", "out/land/terrain.exr", "--sun", "215,25",
                        "--target", "white.svg"}),
                   2, "dark");
}

TEST_F(BadInput, SunBelowTheHorizon) {
    folder.write("bar.svg", kBar);
    ASSERT_EQ(ask({"synth", "land.toml"}).code, 0);
    expect_refused(ask({"check", "--height", "out/land/terrain.exr", "--sun=215,-5",
                        "--target", "bar.svg"}),
                   2, "-5");
}

TEST_F(BadInput, OutputFolderIsAFile) {
    folder.write("taken", "precious");
    expect_refused(ask({"synth", "land.toml", "-o", "taken"}), 1, "taken");
    EXPECT_EQ(fs::file_size(folder / "taken"), 8u);
}

TEST_F(BadInput, OutputFolderIsReadOnly) {
    const SmallDisk disk(folder / "disk", MS_RDONLY);
    if (!disk.mounted()) GTEST_SKIP() << "mounting a file system is not allowed here";
    expect_refused(ask({"synth", "land.toml", "-o", "disk/o"}), 1, "disk/o");
}

TEST_F(BadInput, DiskIsFull) {
    const SmallDisk disk(folder / "disk", 0);
    if (!disk.mounted()) GTEST_SKIP() << "mounting a file system is not allowed here";
    folder.write("disk/ballast", std::string(1 << 20, 'x'));
    expect_refused(ask({"synth", "land.toml", "-o", "disk"}), 1, "disk");

    fs::resize_file(folder / "disk/ballast", 900 << 10);
    expect_refused(
        ask({"synth", "land.toml", "-o", "disk", "--set", "terrain.samples=256"}), 1,
        "disk");
    fs::remove(folder / "disk/ballast");
    EXPECT_EQ(ask({"synth", "land.toml", "-o", "disk"}).code, 0);
}

TEST_F(BadInput, TooLittleMemoryIsRefusedWithTheFigure) {
    const Outcome outcome =
        run({folder.path(), {}, std::size_t{3} << 30},
            {"synth", "land.toml", "--set", "terrain.samples=8192", "--threads", "2"});
    expect_refused(outcome, 1, "9.4 GB");  // 130 bytes a cell, and what is fixed
    EXPECT_NE(outcome.err.find("3.2 GB"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(BadInput, FolderInUse) {
    const Outcome outcome = run_and_signal(
        {folder.path()}, {"synth", "land.toml", "--set", "terrain.samples=3000"}, SIGINT,
        [&] {
            if (!fs::exists(folder / "out/land/.cache/lock")) return false;
            const Outcome second = ask({"synth", "land.toml"});
            EXPECT_EQ(second.code, 1);
            EXPECT_NE(second.err.find("another"), std::string::npos) << second.err;
            return true;
        });
}

TEST_F(BadInput, InfoOnSomethingElse) {
    folder.write("a.txt", "hello");
    folder.write("a.json", "{}");
    folder.write("b.json", "{");
    expect_refused(ask({"info", "a.txt"}), 2, "a.txt");
    expect_refused(ask({"info", "a.json"}), 2, "a.json");
    expect_refused(ask({"info", "b.json"}), 2, "b.json");
    expect_refused(ask({"info", "."}), 2, "folder");
}
