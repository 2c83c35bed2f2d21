// Who may include whom: design section 2, as a test.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

bool starts_with_any(const std::string& text, const std::vector<std::string>& prefixes) {
    for (const std::string& prefix : prefixes) {
        if (text.starts_with(prefix)) return true;
    }
    return false;
}

// "synth/distance/" of "synth/distance/queue.h"; empty for files in synth/ itself.
std::string method_folder(const std::string& path) {
    const std::size_t end = path.find('/', std::string("synth/").size());
    return end == std::string::npos ? "" : path.substr(0, end + 1);
}

// Rooms of what several methods use lie below them all.
const std::vector<std::string> kRoomsBelow = {"synth/geometry/", "synth/hydrology/",
                                              "synth/statistics/"};

// Methods may use one another only downward.
const std::map<std::string, std::vector<std::string>> kMethodsBelow = {
    {"synth/pareidolia/", {"synth/distance/"}},
    {"synth/sketch/", {"synth/texture/", "synth/detail/"}},
    {"synth/genetic/", {"synth/texture/", "synth/detail/"}},
};

// The rooms of one method are used upward only, too: a map knows nothing of evolution.
const std::map<std::string, std::vector<std::string>> kClosedTo = {
    {"synth/genetic/map/", {"synth/genetic/evolution/", "synth/texture/"}},
    {"synth/genetic/evolution/", {"synth/genetic/map/"}},
    {"synth/texture/database/", {"synth/texture/synthesis/"}},
    {"synth/texture/constraints/",
     {"synth/texture/database/", "synth/texture/synthesis/"}},
};

bool synth_may_include(const std::string& file, const std::string& included) {
    if (starts_with_any(included, {"field/", "synth/context.h", "synth/method.h"}))
        return true;
    if (file == "synth/stage.h") return included.starts_with("synth/");
    const std::string folder = method_folder(file);
    if (folder.empty() || !included.starts_with("synth/")) return false;
    for (const auto& [room, closed] : kClosedTo)
        if (file.starts_with(room) && starts_with_any(included, closed)) return false;
    if (starts_with_any(folder, kRoomsBelow)) return included.starts_with(folder);
    if (starts_with_any(included, kRoomsBelow)) return true;
    const auto below = kMethodsBelow.find(folder);
    return included.starts_with(folder) ||
           (below != kMethodsBelow.end() && starts_with_any(included, below->second));
}

// The reader sees options, never what acts on them.
bool config_may_include(const std::string& included) {
    return starts_with_any(included, {"field/", "config/"}) ||
           included == "synth/stage.h" || included == "render/options.h" ||
           (included.starts_with("synth/") && included.ends_with("/options.h"));
}

constexpr const char* kEmbree = "render/embree/embree.h";

// What a shot is made of does not know who draws it, and the text of a .pov knows neither
// the other renderers nor the processes that run.
bool render_may_include(const std::string& file, const std::string& included) {
    static const std::vector<std::string> kDrawers = {"render/pov/", "render/embree/",
                                                      "render/passes/", "render/gltf/",
                                                      "render/frames/"};
    if (!starts_with_any(included, {"field/", "render/"})) return false;
    if (file.starts_with("render/scene/")) return !starts_with_any(included, kDrawers);
    if (file.starts_with("render/pov/"))
        return included.starts_with("render/pov/") ||
               !starts_with_any(included, kDrawers);
    return true;
}

bool may_include(const std::string& file, const std::string& included) {
    if (file.starts_with("field/")) return included.starts_with("field/");
    if (file.starts_with("synth/")) return synth_may_include(file, included);
    // Embree's types stay out of headers.
    if (included == kEmbree && !file.ends_with(".cpp")) return false;
    if (file.starts_with("render/")) return render_may_include(file, included);
    if (file.starts_with("config/")) return config_may_include(included);
    return file.starts_with("app/");
}

// Libraries that one folder keeps to itself.
bool may_use_library(const std::string& file, const std::string& header) {
    if (header.starts_with("embree")) return file == kEmbree;
    if (header.starts_with("toml++")) return file.starts_with("config/");
    if (header.starts_with("CLI/")) return file.starts_with("app/");
    if (header == "sys/wait.h" || header == "spawn.h")  // whoever starts a process
        return file.starts_with("render/frames/") || file.starts_with("app/");
    return true;
}

std::vector<std::string> broken_rules(const fs::path& root, const std::string& file) {
    static const std::regex kInclude(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<std::string> broken;
    std::ifstream in(root / file);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        std::smatch match;
        if (!std::regex_search(line, match, kInclude)) continue;
        const bool ours = match[1] == "\"";
        if (ours ? !may_include(file, match[2]) : !may_use_library(file, match[2])) {
            broken.push_back(file + ":" + std::to_string(number) + ": includes " +
                             match[2].str());
        }
    }
    return broken;
}

}  // namespace

TEST(Layering, SourcesIncludeOnlyWhatTheirFolderMay) {
    const fs::path root = CYDONIA_SOURCE_DIR;
    int files = 0;
    for (const char* folder : {"field", "synth", "render", "config", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp") continue;
            ++files;
            const std::string file = fs::relative(entry.path(), root).generic_string();
            for (const std::string& rule : broken_rules(root, file)) {
                ADD_FAILURE() << rule;
            }
        }
    }
    EXPECT_GT(files, 50);
}

TEST(Layering, SynthAndRenderDoNotKnowEachOther) {
    EXPECT_FALSE(may_include("synth/distance/distance.cpp", "render/shadow/caster.h"));
    EXPECT_FALSE(may_include("render/shadow/check.cpp", "synth/context.h"));
}

TEST(Layering, FieldLooksNowhere) {
    EXPECT_FALSE(may_include("field/dem.cpp", "synth/context.h"));
    EXPECT_FALSE(may_include("field/dem.cpp", "config/reader/scene.h"));
    EXPECT_TRUE(may_include("field/dem.cpp", "field/terrain.h"));
}

TEST(Layering, MethodsUseOneAnotherDownwardOnly) {
    EXPECT_TRUE(may_include("synth/pareidolia/a.cpp", "synth/distance/graph.h"));
    EXPECT_FALSE(may_include("synth/distance/a.cpp", "synth/pareidolia/target.h"));
    EXPECT_FALSE(may_include("synth/distance/a.cpp", "synth/stage.h"));
    EXPECT_TRUE(may_include("synth/sketch/a.cpp", "synth/texture/a.h"));
    EXPECT_FALSE(may_include("synth/texture/a.cpp", "synth/sketch/a.h"));
}

TEST(Layering, RoomsLieBelowMethods) {
    EXPECT_TRUE(may_include("synth/sketch/a.cpp", "synth/geometry/shape.h"));
    EXPECT_TRUE(may_include("synth/texture/database/a.cpp", "synth/statistics/a.h"));
    EXPECT_TRUE(may_include("synth/geometry/course.cpp", "synth/geometry/shape.h"));
    EXPECT_FALSE(may_include("synth/geometry/a.cpp", "synth/texture/options.h"));
    EXPECT_FALSE(may_include("synth/geometry/a.cpp", "synth/statistics/a.h"));
    EXPECT_FALSE(may_include("synth/statistics/a.cpp", "synth/genetic/options.h"));
    EXPECT_FALSE(may_include("synth/genetic/map/a.cpp", "synth/genetic/evolution/a.h"));
    EXPECT_TRUE(may_include("synth/genetic/genetic.cpp", "synth/genetic/evolution/a.h"));
    EXPECT_FALSE(
        may_include("synth/texture/constraints/a.h", "synth/texture/database/a.h"));
}

TEST(Layering, ReaderSeesOptionsOnly) {
    EXPECT_TRUE(may_include("config/reader/a.cpp", "render/options.h"));
    EXPECT_TRUE(may_include("config/reader/a.cpp", "synth/distance/options.h"));
    EXPECT_FALSE(may_include("config/reader/a.cpp", "render/pov/scene.h"));
    EXPECT_FALSE(may_include("config/reader/a.cpp", "app/cache.h"));
}

TEST(Layering, AShotDoesNotKnowWhoDrawsIt) {
    for (const char* drawer : {"render/pov/scene.h", "render/embree/diagram.h",
                               "render/passes/view.h", "render/gltf/scene.h"})
        EXPECT_FALSE(may_include("render/scene/shot.h", drawer)) << drawer;
    EXPECT_TRUE(may_include("render/scene/shot.cpp", "render/sky/haze.h"));
    EXPECT_TRUE(may_include("render/passes/view.cpp", "render/scene/shot.h"));
}

TEST(Layering, ThePovIsTextAndStartsNoProcess) {
    EXPECT_FALSE(may_include("render/pov/files.cpp", "render/frames/povray.h"));
    EXPECT_FALSE(may_include("render/pov/files.cpp", "render/passes/view.h"));
    EXPECT_TRUE(may_include("render/pov/files.cpp", "render/pov/scene.h"));
    EXPECT_FALSE(may_use_library("render/pov/files.cpp", "sys/wait.h"));
    EXPECT_TRUE(may_use_library("render/frames/child.cpp", "sys/wait.h"));
}

TEST(Layering, LibrariesStayInTheirFolder) {
    EXPECT_FALSE(may_use_library("render/shadow/caster.h", "embree3/rtcore.h"));
    EXPECT_FALSE(may_use_library("synth/stage.h", "toml++/toml.h"));
    EXPECT_FALSE(may_use_library("render/options.h", "CLI/CLI.hpp"));
}
