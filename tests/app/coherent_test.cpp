// Land that keeps to the last run's: what that was is remembered across runs.
#include <gtest/gtest.h>

#include "field/dem.h"
#include "field/files.h"
#include "tests/app/hills.h"
#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

const std::string kScene = R"(seed = 7
[terrain]
extent = [1600.0, 1600.0]
samples = 160
[[terrain.stage]]
method = "texture"
exemplars = "hills.tif"
levels = 3
coherent = true
[[terrain.stage.point]]
at = [400.0, 400.0]
height = 330.0
radius = 150.0
)";

struct Coherent : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/land";
    Coherent() {
        folder.write("land.toml", kScene);
        write_geotiff(folder / "hills.tif", hills());
    }
    std::string land(const std::string& set = "title=A", const std::string& flag = "") {
        std::vector<std::string> arguments{"synth", "land.toml", "--set", set};
        if (!flag.empty()) arguments.push_back(flag);
        const Outcome outcome = run({folder.path()}, arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return read_text(out / "terrain.tif");
    }
    // As a full cache would be.
    void forget_terrains() const {
        for (const std::string& file : files_below(out / ".cache"))
            if (file.ends_with(".terrain")) fs::remove(out / ".cache" / file);
        fs::remove(out / "terrain.tif");
    }
};

const std::string kEdit = "terrain.stage[0].point[0].height=280.0";

}  // namespace

TEST_F(Coherent, TheSameSceneIsTheSameLandHoweverOftenItIsMade) {
    const std::string first = land();
    forget_terrains();
    EXPECT_EQ(land(), first);
    const std::string edited = land(kEdit);
    EXPECT_NE(edited, first);
    forget_terrains();
    EXPECT_EQ(land(kEdit), edited);
    fs::remove(out / "terrain.tif");
    EXPECT_EQ(land(kEdit, "--explain"), edited);
}

// What was made before an edit is not what the run after it keeps to.
TEST_F(Coherent, AnEditTakenBackKeepsToTheEdit) {
    land();
    land(kEdit);
    const auto last = [&] { return read_text(out / ".cache/stage-1.texture.runs"); };
    const std::string runs = last();
    land();
    EXPECT_NE(last(), runs);
}
