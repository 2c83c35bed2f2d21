#include <fmt/format.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

using Docs = SceneFile;

std::string page(const char* name) {
    return read_text(std::filesystem::path(CYDONIA_SOURCE_DIR) / "docs" / name);
}
std::string manual() { return page("scene-file.md"); }

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// "terrain.stage[0].grain" -> "0 m + 0.0078125 width", for every value of a scene.
std::map<std::string, std::string> values_of(const SceneSpec& scene) {
    std::string text = fmt::format(
        "seed = {}\nterrain.extent[0] = {}\nterrain.extent[1] = {}\n"
        "terrain.samples = {}\nterrain.tiles = {}\ntitle = {}\n",
        scene.seed, scene.terrain.width, scene.terrain.depth, scene.terrain.samples,
        scene.terrain.tiles, scene.title);
    for (std::size_t i = 0; i < scene.stages.size(); ++i)
        for (const auto& line : lines_of(scene.stages[i].text))
            text += fmt::format("terrain.stage[{}].{}\n", i, line);
    for (const auto& line : lines_of(scene.render_text)) text += "render." + line + "\n";
    for (const auto& line : lines_of(scene.frames_text)) text += "frames." + line + "\n";

    std::map<std::string, std::string> values;
    for (const auto& line : lines_of(text)) {
        const auto equals = line.find(" = ");
        values[line.substr(0, equals)] = line.substr(equals + 3);
    }
    return values;
}

// Every key of a full scene, or of a part of it: {"terrain", "stage", "grain", ...}.
std::set<std::string> known_keys(const SceneSpec& scene, const std::string& part) {
    static const std::regex word("[a-z_]+");
    std::set<std::string> keys;
    for (const auto& [path, value] : values_of(scene))
        if (path.starts_with(part))
            for (std::sregex_iterator at(path.begin(), path.end(), word), end; at != end;
                 ++at)
                keys.insert(at->str());
    return keys;
}

struct Documented {
    std::string path, value;
};

// Where the plain scene below has a table: "terrain.stage.group.edges." is
// "terrain.stage[0].group[2].edges.".
std::string in_plain_scene(std::string table, const std::string& stage) {
    const std::pair<const char*, std::string> places[] = {
        {"terrain\\.stage", stage},
        {"\\b(image|camera|thing|profile|region|exemplar|point|curve|handle|paste|"
         "mapping|landform)\\.",
         "$1[0]."},
        {"(stage\\[0\\]\\.water)\\.", "$1[0]."},
        {"landform\\[0\\]\\.view", "landform[1].view"},
        {"group\\.(circles)", "group[1].$1"},
        {"group\\.(edges)", "group[2].$1"},
        {"group\\.(lip)", "group[3].$1"},
        {"group\\.", "group[0]."},
    };
    for (const auto& [pattern, place] : places)
        table = std::regex_replace(table, std::regex(pattern), place);
    return table;
}

// A camera of the kind that has the key.
std::string camera_for(const std::string& path) {
    for (const char* key : {"eye_height", "heading", "pitch"})
        if (path == std::string("render.camera[0].") + key)
            return "render.camera=[{name=\"a\",kind=\"stand\",position=[9,9]}]";
    if (path == "render.camera[0].eased")
        return "render.camera=[{name=\"a\",kind=\"path\",key=["
               "{frame=0,eye=[0,0,9],target=[9,9,0]},"
               "{frame=1,eye=[9,0,9],target=[9,9,0]}]}]";
    return "";
}

// For keys that are allowed only with another one: that key of the table, and its value.
std::string needed_for(const std::string& path) {
    const std::pair<const char*, const char*> needs[] = {
        {"cost.azimuth", "kind=gaussian"}, {"cost.centre", "kind=distance"},
        {"cost.less", "share=[0.0, 1.0]"}, {"noise.offset", "kind=ridged"},
        {"noise.gain", "kind=ridged"},     {"strata.hardness", "layers=3"},
        {"paste[0].turn", "exemplar=1"},   {"paste[0].mirror", "exemplar=1"},
        {"sensor_width", "f_stop=8.0"},
    };
    for (const char* key : {"faithful", "natural", "hidden"})
        if (path == std::string("terrain.stage[1].") + key)
            return "terrain.stage[1].solver=constrained";
    if (const std::string camera = camera_for(path); !camera.empty()) return camera;
    for (const auto& [end, need] : needs)
        if (path.ends_with(end)) return path.substr(0, path.rfind('.') + 1) + need;
    return "seed=1";
}

// The rows "| `key` | unit | `default` | ..." under headings that name a table.
std::vector<Documented> documented_defaults() {
    static const std::regex heading("##+ `\\[+([a-z_.]+)\\]+`.*");
    static const std::regex row("\\| `([a-z_]+)` \\|[^|]*\\| `([^`]+)` \\|.*");
    std::vector<Documented> rows;
    const std::map<std::string, int> stages{
        {"distance", 0}, {"pareidolia", 1}, {"dem", 2},    {"texture", 3},
        {"detail", 4},   {"sketch", 5},     {"genetic", 6}};
    std::string prefix, stage;
    for (const auto& line : lines_of(manual())) {
        std::smatch match;
        if (line.starts_with("## "))
            for (const auto& [method, index] : stages)
                if (line.find("\"" + method + "\"") != line.npos)
                    stage = fmt::format("terrain.stage[{}]", index);
        if (std::regex_match(line, match, heading)) {
            prefix = match[1].str() + ".";
            prefix = in_plain_scene(prefix, stage);
        } else if (std::regex_match(line, match, row)) {
            rows.push_back({prefix + match[1].str(), match[2].str()});
        }
    }
    return rows;
}

TEST_F(Docs, EveryKeyIsInTheFullSceneAndInTheManual) {
    const std::string text = manual();
    for (const auto& [file, part] :
         {std::pair{"full.toml", ""}, std::pair{"texture_full.toml", "terrain.stage"}}) {
        const std::string scene = golden_text(file);
        for (const auto& key : known_keys(load(scene).at(0), part)) {
            EXPECT_NE(text.find('`' + key + '`'), text.npos)
                << key << " is not in scene-file.md";
            EXPECT_TRUE(std::regex_search(scene, std::regex("\\b" + key + "\\b")))
                << key << " is not in " << file;
        }
    }
}

TEST_F(Docs, DefaultsAreTheStructs) {
    const std::string plain =
        "[[terrain.stage]]\nmethod = \"distance\"\n"
        "group = [{ peaks = { count = 3 } }, { circles = { count = 3 } },\n"
        "    { edges = { image = \"profile.png\" } }, { lip = { image = \"ridges.svg\" } "
        "}]\n"
        "profile = [{ name = \"own\", points = [[0, 1], [1, 0]] }]\n"
        "region = [{ image = \"ridges.svg\" }]\nwater = [{ image = \"ridges.svg\" }]\n"
        "[[terrain.stage]]\nmethod = \"pareidolia\"\nsolver = \"features\"\n"
        "[[terrain.stage.image]]\ntarget = \"ridges.svg\"\n"
        "[[terrain.stage]]\nmethod = \"dem\"\nsource = \"profile.png\"\n"
        "[[terrain.stage]]\nmethod = \"texture\"\n"
        "exemplar = [{ source = \"profile.png\" }]\n"
        "type = [{ name = \"fell\", colour = \"green\" }]\n"
        "point = [{ at = [0, 0], height = 0 }]\n"
        "paste = [{ exemplar = \"terrain\", to = [0, 0], radius = 1 }]\n"
        "curve = [{ points = [[0, 0], [1, 1]], height = 0 }]\n"
        "[[terrain.stage]]\nmethod = \"detail\"\ntargets = \"profile.png\"\n"
        "mapping = [{ target = 1 }]\n"
        "[[terrain.stage]]\nmethod = \"sketch\"\n"
        "landform = [{ points = [[0, 0], [1, 1]], height = 1, "
        "silhouette = { drawing = \"ridges.svg\" } }, "
        "{ view = { drawing = \"ridges.svg\" } }]\n"
        "region = [{ points = [[0, 0], [1, 1], [0, 1]], "
        "noise = { drawing = \"ridges.svg\" } }]\n"
        "[[terrain.stage]]\nmethod = \"genetic\"\nlibrary = \"kinds.toml\"\n"
        "region = [{ type = \"plain\", outline = [[0, 0], [1, 0], [1, 1]] }]\n"
        "[[render.camera]]\nname = \"a\"\n"
        "[[render.thing]]\nkind = \"rock\"\n[render.water]\n";
    const auto expected = values_of(load(plain).at(0));
    const auto rows = documented_defaults();
    EXPECT_GT(rows.size(), 60u);
    for (const auto& [path, value] : rows) {
        const std::vector<std::string> overrides{needed_for(path), path + "=" + value};
        ASSERT_EQ(complaint(plain, overrides), "") << overrides.back();
        int compared = 0;
        for (const auto& [key, written] : values_of(load(plain, overrides).at(0)))
            if (key == path || key.starts_with(path + "[")) {
                EXPECT_EQ(written, expected.at(key)) << overrides.back();
                ++compared;
            }
        EXPECT_GT(compared, 0) << path;
    }
}

// The ```toml blocks of a page.
std::vector<std::string> examples_of(const std::string& page) {
    const std::string fence = "```toml\n";
    std::vector<std::string> examples;
    for (auto at = page.find(fence); at != page.npos; at = page.find(fence, at)) {
        at += fence.size();
        examples.push_back(page.substr(at, page.find("```", at) - at));
    }
    return examples;
}

TEST_F(Docs, WorkedExamplesRead) {
    for (const char* name : {"andes.tif"}) std::ofstream(folder_ / name) << "a file";
    const auto examples = examples_of(manual());
    for (const std::string& example : examples) EXPECT_EQ(complaint(example), "");
    EXPECT_EQ(examples.size(), 3u);
}

// Blocks may also be parts of a texture stage, whose exemplar is then Jacksboro.
TEST_F(Docs, YourOwnMountainsRead) {
    const auto home = folder_ / "home";
    std::filesystem::create_directories(folder_ / "dems");
    std::filesystem::create_directories(home / "dems" / "alps");
    setenv("HOME", home.c_str(), 1);
    for (const char* name :
         {"dems/valley.tif", "dems/massif.tif", "massif-types.png", "paint.png",
          "paint.svg", "keep.png", "home/dems/alps/n46.tif"})
        std::ofstream(folder_ / name) << "a file";
    const auto examples = examples_of(page("your-own-mountains.md"));
    for (const std::string& example : examples) {
        std::string scene = example;
        const auto has = [&](const char* text) {
            return example.find(text) != example.npos;
        };
        if (!has("exemplar]]") && !has("exemplars ="))
            scene = "exemplars = \"package:jacksboro\"\n" + scene;
        if (!has("method")) scene = "[[terrain.stage]]\nmethod = \"texture\"\n" + scene;
        EXPECT_EQ(complaint(scene), "") << example;
    }
    EXPECT_EQ(examples.size(), 8u);
}

TEST_F(Docs, DetailByExampleReads) {
    for (const char* name : {"base.asc", "paint.svg"})
        std::ofstream(folder_ / name) << "a file";
    const auto examples = examples_of(page("detail.md"));
    for (const std::string& example : examples)
        EXPECT_EQ(complaint(example), "") << example;
    EXPECT_EQ(examples.size(), 3u);
}

TEST_F(Docs, SketchingReads) {
    for (const char* name : {"plan.svg", "skyline.svg", "view.svg"})
        std::ofstream(folder_ / name) << "a file";
    const auto examples = examples_of(page("sketching.md"));
    for (const std::string& example : examples) EXPECT_EQ(complaint(example), "");
    EXPECT_EQ(examples.size(), 7u);
}

TEST_F(Docs, LandByMapReads) {
    std::string kinds = golden_text("kinds.toml");
    for (auto at = kinds.find("high hills"); at != kinds.npos;
         at = kinds.find("high hills"))
        kinds.replace(at, 10, "mountains");
    std::ofstream(folder_ / "lands.toml") << kinds;
    std::ofstream(folder_ / "island.svg")
        << "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'>"
           "<rect id='plain' width='9' height='9'/></svg>";
    const auto examples = examples_of(page("land-by-map.md"));
    for (const std::string& example : examples)
        EXPECT_EQ(complaint(example), "") << example;
    EXPECT_EQ(examples.size(), 3u);
}

TEST_F(Docs, CamerasAndColourRead) {
    const std::string land =
        "[[terrain.stage]]\nmethod = \"distance\"\ngroup = [{ peaks = { count = 3 } }]\n";
    std::size_t count = 0;
    for (const char* name : {"cameras.md", "colour.md"})
        for (const std::string& example : examples_of(page(name))) {
            EXPECT_EQ(complaint(land + example), "") << example;
            ++count;
        }
    EXPECT_EQ(count, 6u);
}

}  // namespace
}  // namespace cydonia::config
