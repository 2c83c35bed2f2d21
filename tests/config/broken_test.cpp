#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

using Broken = SceneFile;

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

// complaint() expects bad_request where load() throws; anything else fails or crashes.

TEST_F(Broken, TruncatedAtEveryByte) {
    const std::string scene = golden_text("full.toml");
    for (std::size_t size = 0; size < scene.size(); ++size)
        complaint(scene.substr(0, size));
}

TEST_F(Broken, EveryByteReplacedOrErased) {
    const std::string scene = golden_text("full.toml");
    const std::string bytes = std::string("\0\n\"\\[{=.#9-", 11) + "\xff\xc3";
    for (std::size_t i = 0; i < scene.size(); ++i) {
        std::string broken = scene;
        if (i % 2 == 0)
            broken[i] = bytes[i / 2 % bytes.size()];
        else
            broken.erase(i, 1);
        complaint(broken);
    }
}

TEST_F(Broken, EveryLineTwice) {
    const std::string scene = golden_text("full.toml");
    for (std::size_t at = 0; at < scene.size();) {
        const std::size_t next = scene.find('\n', at) + 1;
        std::string broken = scene;
        broken.insert(at, scene.substr(at, next - at));
        complaint(broken);
        at = next;
    }
}

TEST_F(Broken, NestsTooDeep) {
    const std::string dots = repeated("a.", 200000) + "a";
    for (const std::string& deep :
         {"[" + dots + "]\n", dots + " = 1\n", "x = { " + dots + " = 1 }\n",
          "x = " + repeated("[", 200000), "x = " + repeated("{a=", 200000),
          "x = [" + repeated("{a.a.a.a.a.a.a.a=[", 10000),
          repeated("\"b c\".", 100000) + "a = 1\n",
          "x = { s = \"\"\"quotes\"\"\"\", " + dots + " = 1 }\n",
          "x = { s = '''a'''', " + dots + " = 1 }\n",
          "s = \"\"\"a\\\"\"\"\"\n" + dots + " = 1\n", "# it's\n" + dots + " = 1\n"})
        EXPECT_NE(complaint(deep).find("nested too deeply"), std::string::npos)
            << deep.substr(0, 60);
}

TEST_F(Broken, TextThatIsNotUtf8) {
    const std::string scene = kLeastScene +
                              "[[terrain.stage]]\nmethod = 'pareidolia'\n"
                              "solver = 'constrained'\nimage = [{ text = 'A' }]\n";
    EXPECT_EQ(complaint(scene), "");
    for (const char* bad : {"\xff", "a\xc3", "\xed\xa0\x80", "\xf4\x90\x80\x80"})
        EXPECT_NE(complaint(scene, {std::string("terrain.stage[1].image[0].text=") + bad})
                      .find("expected text in UTF-8"),
                  std::string::npos);
}

TEST_F(Broken, DotsAndBracketsInTextAndCommentsAreNotNesting) {
    const std::string dots = repeated(".[{", 400);
    EXPECT_EQ(complaint("# " + dots + "\n" + kLeastScene + "# " + dots), "");
    EXPECT_EQ(complaint("title = '" + dots.substr(0, 200) + "'\n" + kLeastScene), "");
}

TEST_F(Broken, TooLarge) {
    EXPECT_NE(complaint(std::string((1 << 20) + 1, '\n')).find("larger than"),
              std::string::npos);
}

TEST_F(Broken, TooManyStagesAndCameras) {
    EXPECT_EQ(
        complaint(repeated(kLeastScene, 65)),
        "scene.toml:1:1: terrain.stage: expected an array of 0 to 64, found an array "
        "of 65");
    EXPECT_NE(complaint(kLeastScene + repeated("[[render.camera]]\n", 65))
                  .find("render.camera: expected an array of 0 to 64"),
              std::string::npos);
}

TEST_F(Broken, ManyMistakesAreCutShort) {
    std::string scene;
    for (int i = 0; i < 60; ++i) scene += "unknown" + std::to_string(i) + " = 1\n";
    EXPECT_NE(complaint(scene + kLeastScene).find("\nand 10 more"), std::string::npos);
}

TEST_F(Broken, TextWithLineBreaks) {
    EXPECT_EQ(
        complaint("title = \"a\\nb\"\n" + kLeastScene),
        "scene.toml:1:9: title: expected one line of text without control characters");
    EXPECT_NE(complaint(kLeastScene + "region = [{ image = \"ridges\\u0000.svg\" }]\n"),
              "");
}

TEST_F(Broken, NoSceneFile) {
    EXPECT_THROW(Scene::load(folder_ / "none.toml"), Error);
    EXPECT_THROW(Scene::load(folder_), Error);
}

TEST_F(Broken, OverridesOfAnyShape) {
    const std::string scene = golden_text("full.toml");
    for (const char* text : {"",
                             "=",
                             "a",
                             "a=",
                             ".=1",
                             "[0]=1",
                             "terrain.stage[=1",
                             "terrain.stage[]=1",
                             "terrain.stage[0=1",
                             "terrain.stage[0]]=1",
                             "terrain.stage[99999999999999999999]=1",
                             "terrain.stage=1",
                             "terrain.stage[0]=1",
                             "terrain.stage[-1].grain=1",
                             "terrain=",
                             "seed=1\nseed=2",
                             "seed=[",
                             "seed=\"\"\"",
                             "seed=\xff",
                             "render={}",
                             "title.=1"})
        complaint(scene, {text});
    EXPECT_NE(complaint(scene, {repeated("a.", 100000) + "a=1"}), "");
    EXPECT_NE(complaint(scene, {"seed=" + repeated("[", 100000)}), "");
}

}  // namespace
}  // namespace cydonia::config
