// Frames to sketch over, and back, through the program that was built.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "field/dem.h"
#include "field/files.h"
#include "field/svg_camera.h"
#include "field/svg_paths.h"
#include "tests/app/hills.h"
#include "tests/app/program.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

constexpr const char* kScene = R"([terrain]
extent = [960.0, 800.0]
samples = 96
[[terrain.stage]]
method = "dem"
source = "hills.tif"
[[render.camera]]
name = "map"
kind = "overhead"
[[render.camera]]
name = "view"
elevation = 15.0
size = [480, 270]
)";

struct SketchFrame : testing::Test {
    TemporaryFolder folder;
    const fs::path drawing = folder / "out/sketch/view.svg";
    SketchFrame() {
        write_geotiff(folder / "hills.tif", hills());
        folder.write("land.toml", kScene);
    }
    Outcome ask(std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {"frame-for-sketch", "land.toml", "-o", "out"});
        return run({folder.path()}, options);
    }
    // As if somebody had drawn in it.
    std::string with_stroke(const std::string& path) const {
        std::string text = read_text(drawing);
        const std::size_t end = text.rfind("</g>");
        return text.insert(end, "<path d='" + path + "'/>");
    }
};

}  // namespace

TEST_F(SketchFrame, HoldsTheCameraAndNoStrokes) {
    const Outcome outcome = ask();
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("view.svg"), std::string::npos);
    EXPECT_EQ(files_below(folder / "out/sketch"),
              (std::vector<std::string>{"plan.svg", "view.svg"}));
    const auto camera = svg_camera(open_source(drawing));
    ASSERT_TRUE(camera);
    EXPECT_LT(camera->eye.y, 0.0);  // it looks north
    EXPECT_TRUE(svg_paths(open_source(drawing), 1e-3).empty());
    EXPECT_NE(read_text(drawing).find("data:image/jpeg;base64,"), std::string::npos);
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
}

TEST_F(SketchFrame, NeverReplacesWhatWasDrawn) {
    ASSERT_EQ(ask().code, 0);
    ASSERT_EQ(ask().code, 0);  // nothing was
    const std::string drawn = with_stroke("M90 200 L240 60 L400 190");
    write_text(drawing, drawn);
    const Outcome outcome = ask();
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("has strokes in it"), std::string::npos) << outcome.err;
    EXPECT_EQ(read_text(drawing), drawn);
    EXPECT_EQ(ask({"--force"}).code, 0);
    EXPECT_NE(read_text(drawing), drawn);
}

// What is drawn over the frame is what the camera of the drawing then sees.
TEST_F(SketchFrame, ComesBackAsASkyline) {
    ASSERT_EQ(ask().code, 0);
    write_text(folder / "drawn.svg", with_stroke("M90 130 L150 70 L200 95 L260 130"));
    std::string scene = kScene;
    scene.insert(scene.find("[[render.camera]]"),
                 "[[terrain.stage]]\nmethod = \"sketch\"\n[[terrain.stage.landform]]\n"
                 "name = \"peaks\"\nview = { drawing = \"drawn.svg\" }\n");
    scene +=
        "[[render.camera]]\nname = \"same\"\nkind = \"drawing\"\n"
        "drawing = \"drawn.svg\"\n";
    folder.write("drawn.toml", scene);
    const Outcome outcome = run({folder.path()}, {"synth", "drawn.toml", "-o", "drawn"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto figures = nlohmann::json::parse(read_text(folder / "drawn/manifest.json"))
                             .at("figures")
                             .at("terrain")
                             .at("figures");
    EXPECT_LT(figures.at("sketch: 'peaks' off its stroke in the view, on average, px"),
              1.0);
    // The drawing's camera stays where it was, whatever has risen.
    const Outcome again = run({folder.path()}, {"frame-for-sketch", "drawn.toml", "-o",
                                                "drawn", "--quality", "draft"});
    ASSERT_EQ(again.code, 0) << again.err;
    const auto before = svg_camera(open_source(folder / "drawn.svg")),
               after = svg_camera(open_source(folder / "drawn/sketch/same.svg"));
    EXPECT_EQ(before->eye, after->eye);
    EXPECT_EQ(before->target, after->target);
}

TEST_F(SketchFrame, CamerasOfOtherDrawingsAreRefused) {
    folder.write("other.svg",
                 "<svg xmlns='http://www.w3.org/2000/svg' width='9' "
                 "height='9'/>");
    folder.write("land.toml", std::string(kScene) +
                                  "[[render.camera]]\nname = \"same\"\n"
                                  "kind = \"drawing\"\ndrawing = \"other.svg\"\n");
    const Outcome outcome = ask();
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("names no camera"), std::string::npos) << outcome.err;
}
