// report.html as a browser shows it: headless Chromium, driven by report.js through node.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "render/frames/child.h"
#include "render/frames/program.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;
using Json = nlohmann::ordered_json;

namespace {

struct ReportFile : testing::Test {
    TemporaryFolder folder;
    const fs::path out = folder / "out/land";
    ReportFile() {
        folder.write("land.toml", kShadowScene);
        folder.write("bar.svg", kBar);
    }

    Outcome report(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"report", "land.toml", "--quality", "draft"});
        return run({folder.path()}, more);
    }
    bool is_made(const Outcome& outcome) const {
        return outcome.err.find("report  ") != std::string::npos;
    }
    std::string page() const {
        std::ifstream in(out / "report.html");
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

// What a page's driver prints; with its errors, which are no JSON.
std::string told_by_node(const std::vector<std::string>& arguments) {
    std::string text;
    render::Child node(*render::program_on_path("node"), arguments, ".");
    while (node.read(text, std::chrono::milliseconds(100)))
        ;
    return text;
}

}  // namespace

TEST_F(ReportFile, IsMadeOnceAndAgainWhenWhatItShowsHasChanged) {
    ASSERT_EQ(report({"--force"}).code, 0);
    std::ifstream in(out / "manifest.json");
    const Json manifest = Json::parse(in);
    EXPECT_EQ(manifest.at("outputs").back().at("file"), "report.html");
    EXPECT_NE(page().find("twelve suns"), std::string::npos);
    EXPECT_FALSE(fs::exists(out / "frames"));
    EXPECT_FALSE(fs::exists(out / "pov"));

    EXPECT_FALSE(is_made(report({"--force"})));
    EXPECT_TRUE(is_made(report({"--force", "--set", "seed=8"})));
    EXPECT_TRUE(is_made(report({"--force", "--set", "seed=8", "--set", "title=Other"})));
    EXPECT_NE(page().find("<h1>Other</h1>"), std::string::npos);
    fs::remove(out / "report.html");
    EXPECT_TRUE(is_made(report({"--force", "--set", "seed=8", "--set", "title=Other"})));
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
}

// Of what was made last, unless something else is asked for.
TEST_F(ReportFile, AsksForWhatWasAskedForLast) {
    ASSERT_EQ(report({"--force", "--set", "title=Own"}).code, 0);
    fs::remove(out / "report.html");
    ASSERT_EQ(run({folder.path()}, {"report", "land.toml", "--force"}).code, 0);
    EXPECT_NE(page().find("<h1>Own</h1>"), std::string::npos);
    std::ifstream in(out / "manifest.json");
    EXPECT_EQ(Json::parse(in).at("quality"), "draft");
}

TEST_F(ReportFile, IsThereWhenTheCheckFallsShort) {
    const Outcome outcome = report({"--set", "terrain.stage[0].image[0].min_iou=1.0"});
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    EXPECT_NE(page().find("falls short"), std::string::npos);
}

TEST_F(ReportFile, OpensInChromium) {
    for (const char* program : {"chromium", "node"})
        if (!render::program_on_path(program))
            GTEST_SKIP() << program << " is not installed";
    const std::string title = "</script><script>throw 1</script>";
    ASSERT_EQ(report({"--force", "--set", "title=\"" + title + "\""}).code, 0);
    const char* shots = std::getenv("CYDONIA_SCREENSHOTS");  // to look at
    const Json told =
        Json::parse(told_by_node({CYDONIA_SOURCE_DIR "/tests/e2e/report.js",
                                  (out / "report.html").string(), shots ? shots : ""}));

    EXPECT_EQ(told.at("title"), title);
    EXPECT_EQ(told.at("errors"), Json::array());
    EXPECT_EQ(told.at("requests"), Json::array());
    EXPECT_EQ(told.at("phone"), 390);  // nothing to scroll sideways
    EXPECT_LT(told.at("wall"),
              1.5);  // samples that a block's shadow is too long or short
    EXPECT_NE(told.at("dark"), told.at("switched"));
    EXPECT_EQ(told.at("flat").at("errors"), Json::array());
    EXPECT_EQ(told.at("webgl").at("says"), "");
    EXPECT_NE(told.at("flat").at("says"), "");
    for (const char* way : {"webgl", "flat"}) {
        const Json& used = told.at(way);
        EXPECT_EQ(used.at("steady"), true) << way;
        EXPECT_EQ(used.at("moves"), true) << way;
        // Near the image's sun the image is not to be seen; under it, it is.
        EXPECT_LT(std::stoi(used.at("before").get<std::string>()), 50) << used;
        EXPECT_GT(std::stoi(used.at("found").get<std::string>()), 80) << used;
    }
}
