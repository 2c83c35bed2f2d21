#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

const std::string kTexture =
    "[[terrain.stage]]\nmethod = 'texture'\nexemplars = 'fell.tif'\n";

struct Tiles : SceneFile {
    Tiles() { std::ofstream(folder_ / "fell.tif") << "heights"; }

    // The message for land with these keys and stages.
    std::string wrong(const std::string& terrain, const std::string& stages = kTexture) {
        return complaint("[terrain]\n" + terrain + stages);
    }
    void expect_wrong(const std::string& words, const std::string& terrain,
                      const std::string& stages = kTexture) {
        const std::string message = wrong(terrain, stages);
        EXPECT_NE(message.find(words), message.npos) << "'" << message << "'";
    }
};

TEST_F(Tiles, LandIsMadeWholeUnlessAsked) {
    EXPECT_EQ(load(kLeastScene).at(0).terrain.tiles, 0);
    EXPECT_EQ(load("[terrain]\ntiles = 512\n" + kTexture).at(0).terrain.tiles, 512);
}

TEST_F(Tiles, MoreSamplesThanMemoryHoldsNeedTiles) {
    EXPECT_EQ(wrong("samples = 16384\n"), "");
    expect_wrong(
        "scene.toml:2:11: terrain.samples: more than 16384 samples are made in "
        "tiles: add tiles = 2048",
        "samples = 16385\n");
    EXPECT_EQ(wrong("samples = 65536\ntiles = 2048\n"), "");
    expect_wrong("must be 2 to 65536", "samples = 65537\ntiles = 2048\n");
}

TEST_F(Tiles, SizesThatBlocksAndFoldersTake) {
    expect_wrong("tiles: must be a multiple of 256", "tiles = 300\n");
    expect_wrong("terrain.tiles: -256 is out of range", "tiles = -256\n");
    expect_wrong("terrain.tiles: 8448 is out of range", "tiles = 8448\n");
    EXPECT_EQ(wrong("samples = 16384\ntiles = 256\n"), "");
    expect_wrong(
        "tiles: at most 64 tiles along a side are possible: set tiles to 512 or more",
        "samples = 16385\ntiles = 256\n");
}

TEST_F(Tiles, OneStageThatMakesAnyPartAlone) {
    const std::string tiles = "tiles = 256\n";
    expect_wrong("a first stage that makes it, and only detail stages", tiles,
                 kTexture + kTexture);
    expect_wrong("its paths cross the whole land", tiles, kLeastScene);
    expect_wrong("breach follows", tiles, kTexture + "breach = true\n");
    expect_wrong("coherent keeps", tiles, kTexture + "coherent = true\n");
}

}  // namespace
}  // namespace cydonia::config
