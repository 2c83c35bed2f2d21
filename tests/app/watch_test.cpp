// The preview that follows the scene.
#include <gtest/gtest.h>

#include <csignal>

#include "field/files.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

struct Watch : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/land";
    Watch() { folder.write("land.toml", kSmallScene); }

    std::string state() const {
        return fs::exists(out / "watch.js") ? read_text(out / "watch.js") : "";
    }
    bool says(const std::string& words) const {
        return state().find(words) != std::string::npos;
    }
};

}  // namespace

TEST_F(Watch, DrawsAgainOnEachSaveAndSaysWhatIsWrong) {
    int saved = 0;
    std::string first, other;
    const auto picture = [&] { return read_text(out / "frames/overhead.natural.png"); };
    const auto done = [&] {
        if (saved == 0 && says("\"drawn\":1")) {
            first = picture();
            folder.write("land.toml", kSmallScene + "sead = 1\n");
            ++saved;
        }
        if (saved == 1 && says("\"drawn\":2")) {
            EXPECT_TRUE(says("unknown key 'sead'")) << state();
            std::string scene = kSmallScene;
            scene.replace(scene.find("seed = 7"), 8, "seed = 8");
            folder.write("land.toml", scene);
            ++saved;
        }
        if (saved == 2 && says("\"drawn\":3")) {
            EXPECT_TRUE(says("\"error\":\"\"")) << state();
            other = picture();
            return true;
        }
        return false;
    };
    const Outcome outcome =
        run_and_signal({folder.path()}, {"watch", "land.toml"}, SIGINT, done);
    EXPECT_EQ(outcome.signal, SIGINT) << outcome.err;
    EXPECT_TRUE(fs::exists(out / "watch.html"));
    EXPECT_FALSE(first.empty());
    EXPECT_NE(first, other);
}

TEST_F(Watch, ASceneThatIsWrongFromTheFirstIsRefused) {
    folder.write("land.toml", "sead = 1");
    const Outcome outcome = run({folder.path()}, {"watch", "land.toml"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_FALSE(fs::exists(folder / "out"));
}
