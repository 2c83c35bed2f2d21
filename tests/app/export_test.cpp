// Land for printers and other programs, through the program that was built.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "field/files.h"
#include "field/image.h"
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
    nlohmann::json json_in(const std::string& file) const {
        return nlohmann::json::parse(read_text(folder / file));
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
    std::vector<std::string> expected;
    for (const auto& [format, extension] : {std::pair{"stl", "stl"},
                                            {"obj", "obj"},
                                            {"ply", "ply"},
                                            {"glb", "glb"},
                                            {"ter", "ter"},
                                            {"tif", "tif"},
                                            {"png16", "png"},
                                            {"raw16", "r16"},
                                            {"raw32", "r32"},
                                            {"exr", "exr"},
                                            {"xyz", "xyz"}}) {
        const Outcome outcome = ask({"--to", format, "--quiet"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        for (const char* end : {"", ".json"})
            expected.push_back(std::string("land.") + extension + end);
        const auto sidecar =
            json_in(std::string("out/export/land.") + extension + ".json");
        EXPECT_EQ(sidecar.at("file"), std::string("land.") + extension);
        EXPECT_EQ(sidecar.at("format"), format);
        EXPECT_TRUE(sidecar.at("axes").contains("up"));
        EXPECT_TRUE(sidecar.contains("origin"));
    }
    std::ranges::sort(expected);
    EXPECT_EQ(files_below(folder / "out/export"), expected);
    EXPECT_EQ(temporary_files(folder.path()), std::vector<std::string>{});
}

// The ".json" alone is enough to get the land's metres from the levels.
TEST_F(Export, SidecarsSayHowToGetMetres) {
    EXPECT_EQ(ask({"--to", "raw16"}).code, 0);
    const auto sidecar = json_in("out/export/land.r16.json");
    EXPECT_EQ(sidecar.at("samples"), nlohmann::json::array({64, 64}));
    EXPECT_EQ(sidecar.at("spacing"), 20.0);
    EXPECT_EQ(sidecar.at("byte_order"), "little-endian");
    EXPECT_EQ(sidecar.at("rows"), "from north to south");
    const double offset = sidecar.at("metres").at("offset");
    const double scale = sidecar.at("metres").at("scale");
    const Field<float> heights = read_exr(folder / "out/terrain.exr");
    const std::string raw = read_text(folder / "out/export/land.r16");
    ASSERT_EQ(raw.size(), 2 * heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
        std::uint16_t level;
        std::memcpy(&level, raw.data() + 2 * i, 2);
        ASSERT_NEAR(offset + scale * level, double(heights[i]), 0.51 * scale);
    }
    const auto range = sidecar.at("range").at("metres");
    EXPECT_NEAR(range[0].get<double>(), double(std::ranges::min(heights)), scale);
    EXPECT_NEAR(range[1].get<double>(), double(std::ranges::max(heights)), scale);
}

TEST_F(Export, HeightsAreAveragedToFewerSamples) {
    const Outcome outcome = ask({"--to", "raw32", "--samples", "16"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(json_in("out/export/land.r32.json").at("spacing"), 80.0);
    EXPECT_EQ(fs::file_size(folder / "out/export/land.r32"), 16u * 16 * 4);
    EXPECT_NE(outcome.err.find("16 x 16 samples 80 m apart"), std::string::npos)
        << outcome.err;
}

TEST_F(Export, GltfHasTheScenesCameraAndSun) {
    const Outcome outcome = ask({"--to", "glb", "--samples", "32"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto sidecar = json_in("out/export/land.glb.json");
    EXPECT_EQ(sidecar.at("unit"), "metre");
    EXPECT_EQ(sidecar.at("axes").at("up"), "y");
    EXPECT_EQ(sidecar.at("cameras"), nlohmann::json::array({"overhead"}));
    EXPECT_EQ(sidecar.at("triangles"), 2 * 31 * 31);
    // What the frames show is what it has: another sun is another file.
    const std::string before = read_text(folder / "out/export/land.glb");
    EXPECT_EQ(ask({"--to", "glb", "--set", "render.sun.azimuth=90", "--set",
                   "render.sun.elevation=20"})
                  .code,
              0);
    EXPECT_NE(read_text(folder / "out/export/land.glb"), before);
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
    EXPECT_NE(outcome.err.find("nearly flat"), std::string::npos) << outcome.err;
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
    for (const char* format : {"glb", "ter", "raw16", "xyz"})
        for (const char* samples : {"0", "1", "-5", "100000", "99999999999"})
            expect_refused({"--to", format, "--samples", samples}, "samples");
    expect_refused({"--to", "glb", "--size", "100"}, "--size is for the solids");
    expect_refused({"--to", "raw16", "--scale-z", "2"}, "--scale-z is for the solids");
    expect_refused({"--to", "xyz", "--base", "2"}, "--base is for the solids");
    expect_refused({"--to", "stl", "--dry-run", "--size", "0"}, "size: ");
}
