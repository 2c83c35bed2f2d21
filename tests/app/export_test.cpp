// Land as a solid, through the program that was built.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "field/files.h"
#include "field/solid.h"
#include "render/shadow/caster.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

struct Export : testing::Test {
    TemporaryFolder folder;
    Export() { folder.write("land.toml", kSmallScene); }

    Outcome ask(std::vector<std::string> options) const {
        options.insert(options.begin(), {"export", "land.toml", "-o", "out"});
        return run({folder.path()}, options);
    }
    nlohmann::json figures(const std::string& step) const {
        return nlohmann::json::parse(read_text(folder / "out/manifest.json"))
            .at("figures")
            .at(step);
    }
    void expect_refused(const std::vector<std::string>& options,
                        const std::string& reason) const {
        const Outcome outcome = ask(options);
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(folder / "out")) << "refused before any work";
    }
};

}  // namespace

TEST_F(Export, AnStlUnlessAnotherFormatIsNamed) {
    const Outcome outcome = ask({});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("export/land.stl: 150.0 x 150.0 mm"), std::string::npos)
        << outcome.err;
    const std::string stl = read_text(folder / "out/export/land.stl");
    std::uint32_t triangles;
    std::memcpy(&triangles, stl.data() + 80, 4);
    EXPECT_EQ(triangles, 2 * 63 * 63 + 3 * 4 * 63);
    EXPECT_EQ(stl.size(), 84u + 50u * triangles);
    const auto made = figures("export stl");
    EXPECT_EQ(made.at("triangles"), triangles);
    EXPECT_NEAR(made.at("millimetres_a_metre").get<double>(), 150.0 / 1260.0, 1e-12);
}

TEST_F(Export, EveryFormatBesideTheOthers) {
    for (const char* format : {"stl", "obj", "ply", "glb"})
        EXPECT_EQ(ask({"--to", format, "--quiet"}).code, 0);
    EXPECT_EQ(files_below(folder / "out/export"),
              (std::vector<std::string>{"land.glb", "land.obj", "land.ply", "land.stl"}));
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
}

TEST_F(Export, NotTwiceAndAnewForAnotherSize) {
    ask({"--size", "80"});
    const std::string first = read_text(folder / "out/export/land.stl");
    const Outcome again = ask({"--size", "80"});
    EXPECT_NE(again.err.find("nothing to do"), std::string::npos) << again.err;
    EXPECT_NE(again.err.find("80.0 x 80.0 mm"), std::string::npos)
        << "what it is is said again: " << again.err;
    ask({"--size", "81"});
    EXPECT_NE(read_text(folder / "out/export/land.stl"), first);
}

TEST_F(Export, FewerSamplesAreSaid) {
    const Outcome outcome = ask({"--samples", "32"});
    EXPECT_NE(outcome.err.find("64 x 64 samples were averaged to 32 x 32"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(figures("export stl").at("triangles"), 2 * 31 * 31 + 3 * 4 * 31);
}

TEST_F(Export, FlatLandIsAPlateAndSaysSo) {
    const Outcome outcome = ask({"--set", "terrain.stage[0].vertical_scale=1e-6"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("as good as flat"), std::string::npos) << outcome.err;
}

TEST_F(Export, SaysWhereTheLampStands) {
    folder.write("bar.svg", kBar);
    folder.write("land.toml", kShadowScene);
    const Outcome outcome = ask({"--scale-z", "2"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto lamp = figures("export stl").at("lamps").at(0);
    const double sun = lamp.at("sun").at("elevation"),
                 at = lamp.at("lamp").at("elevation");
    EXPECT_NEAR(std::tan(radians(at)), 2.0 * std::tan(radians(sun)), 1e-9);
    EXPECT_NE(outcome.err.find("appears under a lamp at azimuth"), std::string::npos);
    EXPECT_NE(outcome.err.find("(the scene's sun: "), std::string::npos) << outcome.err;
}

// What the corrected lamp stands on: the caster itself.
TEST(Lamp, CastsTheSameImageOnHigherHeights) {
    Field<float> heights(96, 96), higher(96, 96);
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            heights(x, y) =
                40.0f * float(std::sin(0.31 * x) * std::cos(0.23 * y + 0.1 * x));
            higher(x, y) = 2.5f * heights(x, y);
        }
    }
    const Sun sun{radians(215.0), radians(25.0)};
    const auto cast = render::Caster(heights, 10.0).shadow(sun, 2);
    const auto same =
        render::Caster(higher, 10.0).shadow(lamp_for(sun, {.scale_z = 2.5}), 2);
    std::size_t dark = 0, different = 0;
    for (std::size_t i = 0; i < cast.size(); ++i) {
        dark += cast[i];
        different += cast[i] != same[i];
    }
    EXPECT_GT(dark, cast.size() / 10);
    EXPECT_LT(different, cast.size() / 1000);  // rays that graze an edge
}

TEST_F(Export, BadInput) {
    expect_refused({"--size", "0"}, "size: 0 is not between 1 and 10000 mm");
    expect_refused({"--size", "1e9"}, "size: ");
    expect_refused({"--size", "nan"}, "size: ");
    expect_refused({"--size", "big"}, "--size");
    expect_refused({"--base", "0"}, "base: 0 is not between 0.1 and 1000 mm");
    expect_refused({"--scale-z", "-1"}, "scale-z: ");
    expect_refused({"--samples", "1"}, "samples: ");
    expect_refused({"--samples", "100000"}, "samples: ");
    expect_refused({"--to", "step"}, "step");
    expect_refused({"--to", "stl", "--dry-run", "--size", "0"}, "size: ");
}
