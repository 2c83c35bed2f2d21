#include <algorithm>
#include <cstdlib>

#include "field/packaged.h"
#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

using namespace texture;
namespace fs = std::filesystem;

const std::string kStage = "[[terrain.stage]]\nmethod = 'texture'\n";

class TextureStage : public SceneFile {
  protected:
    TextureStage() {
        fs::create_directories(folder_ / "dems");
        for (const char* name : {"b.tif", "a.tif", "c.tif.aux.xml", ".d.tif", "[e].tif"})
            write("dems", name);
        for (const char* name : {"fell.tif", "types.png"}) write(".", name);
    }
    void write(const fs::path& below, const std::string& name) {
        std::ofstream(folder_ / below / name) << name;
    }
    SceneSpec scene(const std::string& keys) { return load(kStage + keys).at(0); }
    Options stage(const std::string& keys) {
        return std::get<Options>(scene(keys).stages.at(0).options);
    }
    // The message for a stage with one exemplar and these keys.
    std::string wrong(const std::string& keys) {
        return complaint(kStage + "exemplars = 'fell.tif'\n" + keys);
    }
    std::vector<std::string> exemplars(const std::string& keys) {
        std::vector<std::string> names;
        for (const Exemplar& exemplar : stage(keys).exemplars)
            names.push_back(exemplar.source.name());
        return names;
    }
};

using Names = std::vector<std::string>;

TEST_F(TextureStage, OneExemplarIsEnough) {
    const Options o = stage("exemplars = 'fell.tif'\n");
    ASSERT_EQ(o.exemplars.size(), 1u);
    EXPECT_EQ(o.exemplars[0].source.path, folder_ / "fell.tif");
    EXPECT_EQ(o.levels, 6);
    EXPECT_EQ(o.jitter, 0.2);
}

TEST_F(TextureStage, ExemplarsAreSortedFilesOfAPatternAmongOthers) {
    EXPECT_EQ(exemplars("exemplars = ['fell.tif', 'dems/*.tif', 'dems/a.tif']\n"),
              (Names{"fell.tif", "[e].tif", "a.tif", "b.tif", "a.tif"}));
    EXPECT_EQ(exemplars("exemplars = 'dems/?.tif'\n"), (Names{"a.tif", "b.tif"}));
    EXPECT_EQ(exemplars("exemplars = 'dems/[e]*'\n"), (Names{"[e].tif"}));
}

TEST_F(TextureStage, ListComesBeforeTables) {
    EXPECT_EQ(exemplars("exemplars = 'fell.tif'\n"
                        "[[terrain.stage.exemplar]]\nsource = 'dems/b.tif'\n"),
              (Names{"fell.tif", "b.tif"}));
}

TEST_F(TextureStage, HomeFolder) {
    const char* home = std::getenv("HOME");
    const std::string before = home ? home : "";
    setenv("HOME", folder_.c_str(), 1);
    EXPECT_EQ(exemplars("exemplars = ['~/dems/?.tif', '~/fell.tif']\n"),
              (Names{"a.tif", "b.tif", "fell.tif"}));
    setenv("HOME", before.c_str(), 1);
}

TEST_F(TextureStage, PackagedModelsAreHashedWithTheirData) {
    const Options o = stage("exemplars = ['package:jacksboro', 'package:topography']\n");
    ASSERT_EQ(o.exemplars.size(), 2u);
    EXPECT_TRUE(is_packaged_dem(o.exemplars[0].source.path));
    EXPECT_NE(o.exemplars[0].source.hash, open_source(o.exemplars[0].source.path).hash);
    EXPECT_GT(o.exemplars[1].source.size, 100000u);
}

TEST_F(TextureStage, CacheKeyHoldsEveryExemplar) {
    const SceneSpec spec = scene(
        "exemplars = 'dems/?.tif'\n[[terrain.stage.exemplar]]\nsource = 'fell.tif'\n");
    EXPECT_EQ(spec.stages[0].sources.size(), 3u);
    const std::string before = spec.stages[0].text;
    write("dems", "c.tif");
    EXPECT_NE(scene("exemplars = 'dems/?.tif'\n[[terrain.stage.exemplar]]\nsource = "
                    "'fell.tif'\n")
                  .stages[0]
                  .text,
              before);
}

TEST_F(TextureStage, Types) {
    const Options o = stage(
        "paint = 'types.png'\n"
        "type = [{ name = 'plain', colour = 'green' }, { name = 'alp', colour = "
        "'#102030' }]\n"
        "[[terrain.stage.exemplar]]\nsource = 'fell.tif'\ntype = 'alp'\n"
        "[[terrain.stage.exemplar]]\nsource = 'dems/a.tif'\ntypes = 'types.png'\n");
    ASSERT_EQ(o.types.size(), 2u);
    EXPECT_EQ(o.types[1].colour, (std::array<std::uint8_t, 3>{16, 32, 48}));
    EXPECT_EQ(o.exemplars[0].type, "alp");
    EXPECT_EQ(o.exemplars[1].types->name(), "types.png");
    EXPECT_EQ(o.paint->name(), "types.png");
}

TEST_F(TextureStage, PointsAndTheirNames) {
    const Options o = stage(
        "exemplars = 'fell.tif'\n"
        "[[terrain.stage.point]]\nat = [1200, '50 %']\nheight = 800\n"
        "[[terrain.stage.point]]\nname = 'summit'\nat = ['10 %', -20]\nheight = 120\n"
        "relative = true\ngradient = [0.5, -0.25]\nradius = 300\n");
    ASSERT_EQ(o.points.size(), 2u);
    EXPECT_EQ(o.points[0].name, "point 1");
    EXPECT_EQ(o.points[0].at, (geometry::Place2{metres(1200), of_width(0.5)}));
    EXPECT_EQ(o.points[1].name, "summit");
    EXPECT_TRUE(o.points[1].relative);
    EXPECT_EQ(o.points[1].gradient[1], -0.25);
    EXPECT_EQ(o.points[1].radius, metres(300));
}

TEST_F(TextureStage, CurvesAndTheirHandles) {
    const Options o = stage(
        "exemplars = 'fell.tif'\n"
        "[[terrain.stage.curve]]\npoints = [[0, 0], ['50 %', 300], [900, 20]]\n"
        "[[terrain.stage.curve.handle]]\nat = 0\nheight = 100\n"
        "[[terrain.stage.curve.handle]]\nat = 1\nheight = 20\ngradient = [-1, 1]\n"
        "area = [100, '5 %']\n"
        "[[terrain.stage.curve]]\ndrawing = 'ridges.svg'\nid = 'a'\nheight = 5\n");
    ASSERT_EQ(o.curves.size(), 2u);
    EXPECT_EQ(o.curves[0].points.at(1), (geometry::Place2{of_width(0.5), metres(300)}));
    EXPECT_EQ(o.curves[0].handles.at(0).height, 100.0);
    EXPECT_FALSE(o.curves[0].handles[0].area);
    EXPECT_EQ(o.curves[0].handles[1].area->at(1), of_width(0.05));
    EXPECT_EQ(o.curves[1].name, "curve 2");
    EXPECT_EQ(o.curves[1].id, "a");
}

TEST_F(TextureStage, PastesFromAnExemplarAndFromTheTerrain) {
    const Options o = stage(
        "exemplars = ['fell.tif', 'dems/a.tif']\n"
        "[[terrain.stage.paste]]\nexemplar = 2\nto = [100, 100]\nturn = 270\n"
        "mirror = true\nraise = -40\n"
        "[[terrain.stage.paste]]\nexemplar = 'fell'\nto = [0, 0]\n"
        "outline = [[-100, 0], [100, 0], [0, 100]]\n"
        "[[terrain.stage.paste]]\nexemplar = 'terrain'\nto = [0, 0]\nradius = 500\n");
    ASSERT_EQ(o.pastes.size(), 3u);
    EXPECT_EQ(o.pastes[0].exemplar, 2);
    EXPECT_EQ(o.pastes[0].turn, 3);
    EXPECT_EQ(o.pastes[1].exemplar, 1);
    EXPECT_EQ(o.pastes[1].outline.size(), 3u);
    EXPECT_EQ(o.pastes[2].exemplar, 0);
    EXPECT_EQ(o.pastes[2].name, "paste 3");
}

TEST_F(TextureStage, HeightsVaryInTime) {
    const Scene varying = load(
        kStage +
        "exemplars = 'fell.tif'\npoint = [{ at = [0, 0], height = { keys = [[0, 100], "
        "[10, 200]] } }]\n");
    const SceneSpec half = varying.at(5);
    EXPECT_EQ(std::get<Options>(half.stages[0].options).points.at(0).height, 150.0);
}

TEST_F(TextureStage, NothingToMakeLandOf) {
    EXPECT_EQ(
        complaint(kStage),
        "scene.toml:1:1: terrain.stage[0].exemplars: there are no exemplars to make land "
        "from; name elevation models, or \"package:jacksboro\" to begin with");
}

TEST_F(TextureStage, FolderWithoutAMatch) {
    EXPECT_EQ(complaint(kStage + "exemplars = ['dems/*.dem']\n"),
              "scene.toml:3:14: terrain.stage[0].exemplars[0]: no file matches '*.dem' "
              "(looked in dems); docs/your-own-mountains.md tells how to get elevation "
              "models");
}

TEST_F(TextureStage, FolderThatIsMissing) {
    const std::string message = complaint(kStage + "exemplars = '~/no such/*.tif'\n");
    EXPECT_NE(message.find("no such': No such file or directory; docs/your-own"),
              message.npos)
        << message;
}

TEST_F(TextureStage, TooManyExemplars) {
    for (int i = 0; i < 256; ++i) write("dems", "x" + std::to_string(i) + ".img");
    EXPECT_NE(complaint(kStage + "exemplars = 'dems/*.img'\n")
                  .find("256 files match 'dems/*.img'; at most 255"),
              std::string::npos);
    EXPECT_NE(complaint(kStage + "exemplars = ['dems/x1*', 'dems/x1*', 'dems/x1*']\n")
                  .find("333 elevation models are too many; at most 255"),
              std::string::npos);
}

TEST_F(TextureStage, OrientationsThatAreNoGroup) {
    for (const char* good : {"1", "2", "4", "8"})
        EXPECT_EQ(wrong(std::string("orientations = ") + good + "\n"), "");
    EXPECT_NE(wrong("orientations = 3\n").find("must be 1, 2, 4 or 8"),
              std::string::npos);
}

// complaint() expects bad_request where load() throws; anything else fails or crashes.
TEST_F(TextureStage, BrokenAtEveryByte) {
    const std::string full = golden_text("texture_full.toml");
    EXPECT_EQ(complaint(full), "");
    const std::string bytes = std::string("\0\"[{=.-9*", 9);
    for (std::size_t i = 0; i < full.size(); ++i) {
        complaint(full.substr(0, i));
        std::string broken = full;
        broken[i] = bytes[i % bytes.size()];
        complaint(broken);
    }
}

}  // namespace
}  // namespace cydonia::config
