// Land made tile by tile, in one process or many: the same heights as made whole.
#include <gtest/gtest.h>

#include <csignal>

#include "field/dem.h"
#include "field/files.h"
#include "field/tiled.h"
#include "tests/app/hills.h"
#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

using Names = std::vector<std::string>;

// 2 x 2 tiles, those of the last column and row cut off.
const std::string kScene = R"(seed = 7
[terrain]
extent = [3000.0, 2600.0]
samples = 300
tiles = 256
[[terrain.stage]]
method = "texture"
exemplars = "hills.tif"
levels = 3
)";

struct Tiles : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/land";
    Tiles() {
        folder.write("land.toml", kScene);
        write_geotiff(folder / "hills.tif", hills());
    }

    Outcome synth(Names arguments = {}) const {
        arguments.insert(arguments.begin(), {"synth", "land.toml"});
        return run({folder.path()}, arguments);
    }
    static Field<float> heights(const fs::path& file) {
        return read_dem(open_source(file)).heights;
    }
    void expect_refused(const Outcome& outcome, const std::string& reason) const {
        EXPECT_EQ(outcome.code, 2);
        EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(out));
    }
};

const Names kAllTiles = {"tile-0-0.tif", "tile-0-1.tif", "tile-1-0.tif", "tile-1-1.tif"};
// 5 x 5 tiles: long enough to be stopped.
const Names kLarge = {"synth", "land.toml", "--set", "terrain.samples=1200"};

}  // namespace

TEST_F(Tiles, AreTheLandMadeWhole) {
    ASSERT_EQ(synth({"--set", "terrain.tiles=0", "-o", "whole"}).code, 0);
    const Outcome outcome = synth();
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Field<float> whole = heights(folder / "whole/terrain.tif");
    EXPECT_EQ(whole.width(), 300);
    EXPECT_EQ(heights(out / "terrain.tif"), whole);
    EXPECT_EQ(heights(out / "terrain.exr"), whole);
    EXPECT_EQ(files_below(out / "tiles"), kAllTiles);
    EXPECT_TRUE(fs::exists(out / "preview.png"));
    EXPECT_EQ(temporary_files(folder.path()), Names{});
}

TEST_F(Tiles, WithDetailsTooAreTheLandMadeWhole) {
    const std::string details = R"([[terrain.stage]]
method = "detail"
targets = "hills.tif"
levels = 2
block = 0.06
)";
    folder.write("land.toml", kScene + details);
    ASSERT_EQ(synth({"--set", "terrain.tiles=0", "-o", "whole"}).code, 0);
    const Outcome outcome = synth();
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(heights(out / "terrain.tif"), heights(folder / "whole/terrain.tif"));
    const Outcome refused =
        synth({"--set", "terrain.stage[1].search=patchmatch", "-o", "no"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find("PatchMatch goes on"), std::string::npos) << refused.err;
}

TEST_F(Tiles, InAnyOrderByProcessesOfTheirOwn) {
    ASSERT_EQ(synth({"-o", "alone"}).code, 0);
    for (const char* place : {"1,1", "0,0"})
        ASSERT_EQ(synth({"--tile", place}).code, 0) << place;
    EXPECT_EQ(files_below(out / "tiles"), (Names{"tile-0-0.tif", "tile-1-1.tif"}));
    EXPECT_FALSE(fs::exists(out / "terrain.tif"));
    EXPECT_NE(synth({"--dry-run"}).out.find("2 x 2 tiles, 2 of 4 made"),
              std::string::npos);

    const auto made = fs::last_write_time(out / "tiles/tile-1-1.tif");
    EXPECT_NE(synth({"--tile", "1,1"}).err.find("tile 1,1 exists already"),
              std::string::npos);
    ASSERT_EQ(synth().code, 0);
    EXPECT_EQ(fs::last_write_time(out / "tiles/tile-1-1.tif"), made);
    for (const char* name : {"terrain.tif", "terrain.exr", "preview.png"})
        EXPECT_EQ(read_text(out / name), read_text(folder / "alone" / name)) << name;
    EXPECT_NE(synth().err.find("nothing to do"), std::string::npos);
}

TEST_F(Tiles, GoOnAfterAnInterrupt) {
    const Outcome stopped = run_and_signal({folder.path()}, kLarge, SIGTERM, [&] {
        return fs::exists(out / "tiles/tile-1-0.tif");
    });
    EXPECT_EQ(stopped.signal, SIGTERM);
    EXPECT_FALSE(fs::exists(out / "terrain.tif"));
    EXPECT_EQ(temporary_files(folder.path()), Names{});
    const auto made = fs::last_write_time(out / "tiles/tile-0-0.tif");

    ASSERT_EQ(run({folder.path()}, kLarge).code, 0);
    EXPECT_EQ(fs::last_write_time(out / "tiles/tile-0-0.tif"), made);
    EXPECT_EQ(files_below(out / "tiles").size(), 25u);
}

// Without a chance to clean up.
TEST_F(Tiles, WhatAKilledRunLeftGoes) {
    const Outcome killed = run_and_signal({folder.path()}, kLarge, SIGKILL, [&] {
        return fs::exists(out / "tiles/tile-1-0.tif");
    });
    EXPECT_EQ(killed.signal, SIGKILL);
    EXPECT_NE(temporary_files(folder.path()), Names{});
    ASSERT_EQ(synth().code, 0);
    EXPECT_EQ(temporary_files(folder.path()), Names{});
}

TEST_F(Tiles, DamagedTilesAndThoseOfAnotherLandAreMadeAgain) {
    ASSERT_EQ(synth().code, 0);
    const std::string land = read_text(out / "terrain.tif");
    const std::string tile = read_text(out / "tiles/tile-1-0.tif");
    folder.write("out/land/tiles/tile-1-0.tif", tile.substr(0, tile.size() / 2));
    fs::copy_file(out / "tiles/tile-0-0.tif", out / "tiles/tile-0-1.tif",
                  fs::copy_options::overwrite_existing);
    fs::remove(out / "terrain.tif");
    ASSERT_EQ(synth().code, 0);
    EXPECT_EQ(read_text(out / "tiles/tile-1-0.tif"), tile);
    EXPECT_EQ(read_text(out / "terrain.tif"), land);

    ASSERT_EQ(synth({"--set", "seed=8"}).code, 0);
    EXPECT_NE(read_text(out / "terrain.tif"), land);
    ASSERT_EQ(synth({"--set", "terrain.tiles=512"}).code, 0);
    EXPECT_EQ(files_below(out / "tiles"), Names{"tile-0-0.tif"});
    EXPECT_EQ(heights(out / "terrain.tif").size(), 300u * 260u);
}

TEST_F(Tiles, PlacesThatTheLandDoesNotHave) {
    for (const char* place : {"0,2", "-1,0"})
        expect_refused(synth({"--tile", place}), "the land has tiles 0,0 to 1,1");
    EXPECT_EQ(synth({"--tile", "1"}).code, 2);
    expect_refused(synth({"--tile", "0,0", "--set", "terrain.tiles=0"}), "has no tiles");
}

TEST_F(Tiles, OnlySynthMakesThem) {
    for (const char* command : {"render", "export"})
        expect_refused(run({folder.path()}, {command, "land.toml"}),
                       "land in tiles is made by synth");
    expect_refused(synth({"--explain"}), "land in tiles is made by synth");
}

TEST_F(Tiles, FoldersThatCannotBeWritten) {
    EXPECT_EQ(synth({"-o", "/proc/land"}).code, 1);
    folder.write("out/land/tiles", "a file in the way");
    for (const Names& arguments : {Names{"--tile", "0,0"}, Names{}}) {
        const Outcome outcome = synth(arguments);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_NE(outcome.err.find("tiles is a file"), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(fs::exists(out / "terrain.tif"));
    EXPECT_EQ(temporary_files(folder.path()), Names{});
}

TEST_F(Tiles, PlanKnowsTheMemoryOfATile) {
    const auto needed = [&](const std::string& set) {
        const std::string plan = synth({"--dry-run", "--set", set}).out;
        return std::stod(plan.substr(plan.find("memory: ") + 8));
    };
    const double small = needed("terrain.samples=16384");
    EXPECT_GT(small, 100.0);  // MB
    EXPECT_LT(small, 1000.0);
    EXPECT_GT(needed("terrain.samples=8192"), 0.9 * small);
}
