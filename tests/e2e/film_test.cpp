// What a film pipeline gets of a scene: frames and passes that fit each other, previews,
// lights; through the program that was built and POV-Ray.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "field/image.h"
#include "tests/app/program.h"
#include "tests/app/scenes.h"
#include "tests/render/no_povray.h"

namespace fs = std::filesystem;
using namespace cydonia;
using namespace cydonia::test;

namespace {

constexpr int kWidth = 240, kHeight = 135;

// Between trees to the horizon, the land around included.
const std::string kView = R"([[render.camera]]
name = "view"
kind = "look_at"
eye = [640.0, 300.0, 90.0]
target = [640.0, 900.0, 180.0]
field_of_view = 60.0
size = [720, 405]
)";

std::string land_with(const std::string& camera, const std::string& render) {
    const std::size_t cameras = kSmallScene.find("[[render.camera]]");
    return kSmallScene.substr(0, cameras) + "[render]\n" + render + camera;
}

struct Film : testing::Test {
    TemporaryFolder folder;
    const fs::path frames = folder / "out/land/frames";

    Outcome render(const std::string& scene, std::vector<std::string> more = {}) {
        folder.write("land.toml", scene);
        std::vector<std::string> arguments{"render", "land.toml", "--quality", "draft"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run({folder.path()}, arguments);
    }
};

struct Part {
    OIIO::ImageSpec spec;
    std::vector<float> values;
    float at(int x, int y, int channel = 0) const {
        return values[static_cast<std::size_t>((y * spec.width + x) * spec.nchannels +
                                               channel)];
    }
};

std::map<std::string, Part> parts_of(const fs::path& file) {
    std::map<std::string, Part> parts;
    const auto in = OIIO::ImageInput::open(file.string());
    if (!in) return parts;
    for (int i = 0; in->seek_subimage(i, 0); ++i) {
        Part part{in->spec(), {}};
        part.values.resize(part.spec.image_pixels() *
                           static_cast<std::size_t>(part.spec.nchannels));
        in->read_image(i, 0, 0, part.spec.nchannels, OIIO::TypeFloat, part.values.data());
        parts[part.spec.get_string_attribute("name")] = std::move(part);
    }
    return parts;
}

// The first row from above that is not sky, column by column.
std::vector<int> skyline(const Part& part, const auto& is_sky) {
    std::vector<int> rows;
    for (int x = 0; x < part.spec.width; ++x) {
        int y = 0;
        while (y < part.spec.height && is_sky(x, y)) ++y;
        rows.push_back(y);
    }
    return rows;
}

}  // namespace

TEST_F(Film, TreesAndTheLandAroundStandInThePassesWhereTheFrameHasThem) {
    if (const auto missing = no_povray()) GTEST_SKIP() << *missing;
    const Outcome outcome = render(land_with(kView, R"(sky = { air = false }
sun = { azimuth = 190.0, elevation = 60.0 }
passes = {}
[[render.thing]]
kind = "conifer"
size = [25.0, 40.0]
density = 60.0
slope = [70.0, 80.0]
)"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto parts = parts_of(frames / "view.passes.exr");
    for (const char* name : {"beauty", "depth", "position", "normal", "height", "slope",
                             "material", "shadow", "sky", "thing"})
        ASSERT_TRUE(parts.contains(name)) << name;
    const Part &beauty = parts.at("beauty"), &depth = parts.at("depth");
    ASSERT_EQ(beauty.spec.width, kWidth);
    ASSERT_EQ(depth.spec.height, kHeight);
    const auto drawn = skyline(beauty, [&](int x, int y) {
        return beauty.at(x, y, 0) + beauty.at(x, y, 1) + beauty.at(x, y, 2) <= 0.0f;
    });
    const auto cast = skyline(depth, [&](int x, int y) { return depth.at(x, y) > 1e9f; });
    int within = 0;
    for (int x = 0; x < kWidth; ++x) within += std::abs(drawn[x] - cast[x]) <= 1;
    EXPECT_GE(within, kWidth * 95 / 100);
    // Trees stand before the sky, so the test is one of them.
    const Part& thing = parts.at("thing");
    int trees = 0;
    for (int x = 0; x < kWidth; ++x)
        trees += cast[x] < kHeight && thing.at(x, cast[x]) > 0.0f;
    EXPECT_GT(trees, kWidth / 10);
}

TEST_F(Film, EachPassInAFileOfItsOwn) {
    if (const auto missing = no_povray()) GTEST_SKIP() << *missing;
    const Outcome outcome = render(land_with(kView, R"([render.passes]
which = ["depth", "normal"]
separate = true
)"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(frames / "view.exr"));
    EXPECT_EQ(parts_of(frames / "view.depth.exr").begin()->second.spec.channelnames,
              std::vector<std::string>{"Z"});
    EXPECT_EQ(parts_of(frames / "view.normal.exr").begin()->second.spec.channelnames,
              (std::vector<std::string>{"N.X", "N.Y", "N.Z"}));
    EXPECT_FALSE(fs::exists(frames / "view.passes.exr"));
}

TEST_F(Film, PassesThatDoNotExist) {
    Outcome outcome = render(land_with(kView, "passes = { which = [\"dephth\"] }\n"));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("'depth'"), std::string::npos) << outcome.err;
    outcome = render(land_with(kView, "passes = { which = [\"sky\", \"sky\"] }\n"));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("none twice"), std::string::npos) << outcome.err;
}

TEST_F(Film, EveryStyleOfPreviewIsAPictureOfItsOwn) {
    std::set<std::string> pictures;
    for (const char* style :
         {"natural", "grey", "height", "slope", "ink", "contours", "radiance"}) {
        const Outcome outcome = render(land_with(kView, "look = \"alpine\"\n"),
                                       {"--engine", "embree", "--style", style});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const Field<float> grey =
            read_grey(open_source(frames / (std::string("view.") + style + ".png")));
        const auto [low, high] = std::ranges::minmax(grey);
        EXPECT_GT(high - low, 0.2f) << style;
        std::string bytes;
        for (const float v : grey) bytes += static_cast<char>(std::lround(99.0f * v));
        pictures.insert(bytes);
    }
    EXPECT_EQ(pictures.size(), 7u);
}

// What is checked is what is drawn: form that breaks the image is found.
TEST_F(Film, AShadowImageIsCheckedOnFinerLand) {
    folder.write("bar.svg", kBar);
    folder.write("land.toml", kShadowScene);
    const auto iou = [&](const std::string& crags) {
        const Outcome outcome =
            run({folder.path()},
                {"check", "land.toml", "--force", "--set", "render.fine_relief.factor=4",
                 "--set", "render.fine_relief.crags=" + crags});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        std::ifstream in(folder / "out/land/manifest.json");
        return nlohmann::json::parse(in)["figures"]["check"]["images"]
            .at(0)["iou"]
            .get<double>();
    };
    EXPECT_LT(iou("3"), iou("0") - 0.01);
}

TEST_F(Film, FinerLandByPowersOfTwoOnly) {
    const Outcome outcome = render(land_with(kView, "fine_relief = { factor = 3 }\n"));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("1, 2, 4 or 8"), std::string::npos) << outcome.err;
}

TEST_F(Film, FinerLandThatIsTooLarge) {
    const Outcome outcome = render(land_with(kView, "fine_relief = { factor = 8 }\n"),
                                   {"--dry-run", "--set", "terrain.samples=4096"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("lower factor"), std::string::npos) << outcome.err;
}
