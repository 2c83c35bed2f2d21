// The looks that ship, and looks of the user.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "field/data.h"
#include "render/ground/ground.h"
#include "tests/config/scene_file.h"

namespace cydonia::config {
namespace {

using render::ground_albedo;
using render::GroundOptions;

class Looks : public SceneFile {
  protected:
    GroundOptions ground(const std::string& render_keys) {
        return load(kLeastScene + "[render]\n" + render_keys).at(0).render.ground;
    }
    std::string complaint_of(const std::string& look, const std::string& material = "") {
        std::ofstream(folder_ / "mine.toml") << look;
        std::ofstream(folder_ / "stone.toml") << material;
        return complaint(kLeastScene + "[render]\nlook = \"mine.toml\"\n");
    }
};

const std::string kStone = "light = [0.3, 0.3, 0.3]\ndark = [0.2, 0.2, 0.2]\n";

std::vector<std::string> shipped() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(data_folder("looks")))
        names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

float luminance(const Rgb& c) { return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]; }

Rgb mean(const Field<Rgb>& image) {
    Rgb sum{};
    for (const Rgb& c : image)
        for (int i = 0; i < 3; ++i) sum[i] += c[i] / static_cast<float>(image.size());
    return sum;
}

// A plane that falls by `slope` toward the south.
Terrain plane(double slope) {
    Terrain terrain;
    terrain.spacing = 10.0;
    terrain.heights = Field<float>(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            terrain.heights(x, y) = static_cast<float>((63 - y) * 10.0 * slope);
    return terrain;
}

// Hills 2 km across, some of them steep.
Terrain hills(int samples) {
    Terrain terrain;
    terrain.spacing = 8000.0 / samples;
    terrain.heights = Field<float>(samples, samples);
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) {
            const double e = (x + 0.5) / samples, s = (y + 0.5) / samples;
            terrain.heights(x, y) =
                static_cast<float>(600.0 * std::sin(25.0 * e) * std::cos(21.0 * s) +
                                   250.0 * std::sin(50.0 * s));
        }
    return terrain;
}

TEST_F(Looks, EveryOneReadsAndIsPhysical) {
    EXPECT_GE(shipped().size(), 12u);
    const Terrain land = hills(128);
    for (const std::string& name : shipped())
        for (const Rgb& c : ground_albedo(land, ground("look = \"" + name + "\""), 1))
            for (float v : c) ASSERT_TRUE(v > 0.008f && v < 0.95f) << name << ' ' << v;
}

TEST_F(Looks, EveryOneIsInTheGuideWithItsPicture) {
    const std::filesystem::path docs = std::filesystem::path(CYDONIA_SOURCE_DIR) / "docs";
    const std::string guide = read_text(docs / "looks.md");
    for (const std::string& name : shipped()) {
        const std::string picture = "pictures/looks/" + name + ".jpg";
        EXPECT_NE(guide.find('`' + name + '`'), guide.npos) << name;
        EXPECT_NE(guide.find(picture), guide.npos) << name;
        ASSERT_TRUE(std::filesystem::exists(docs / picture)) << picture;
        EXPECT_LT(std::filesystem::file_size(docs / picture), 60'000u) << picture;
    }
}

TEST_F(Looks, EveryMaterialIsOfALook) {
    std::string looks;
    for (const std::string& name : shipped())
        looks += read_text(data_file("looks/" + name + ".toml"));
    for (const auto& entry :
         std::filesystem::directory_iterator(data_folder("materials"))) {
        const std::string name = entry.path().stem().string();
        EXPECT_NE(looks.find("= \"" + name + "\""), looks.npos) << name;
    }
}

// A place has the same colour for every number of samples, except for the detail that
// finer land adds.
TEST_F(Looks, AreTheSameForAnyNumberOfSamples) {
    for (const std::string name : {"natural", "alpine", "desert", "green"}) {
        const GroundOptions look = ground("look = \"" + name + "\"");
        const Field<Rgb> coarse = ground_albedo(hills(200), look, 4);
        const Field<Rgb> fine = ground_albedo(hills(400), look, 2);
        ASSERT_TRUE(coarse.same_shape(fine));
        double difference = 0.0, spread = 0.0;
        const float middle = luminance(mean(coarse));
        for (std::size_t i = 0; i < fine.size(); ++i) {
            difference += std::pow(luminance(coarse[i]) - luminance(fine[i]), 2);
            spread += std::pow(luminance(fine[i]) - middle, 2);
        }
        EXPECT_LT(difference, 0.35 * spread) << name;
    }
}

TEST_F(Looks, SteepLandIsRockAndFlatLandIsNot) {
    const Rgb flat = mean(ground_albedo(plane(0.05), ground(""), 2));
    const Rgb steep = mean(ground_albedo(plane(1.5), ground(""), 2));
    EXPECT_LT(flat[2] / flat[0], 0.62f);    // earth and grass: little blue
    EXPECT_GT(steep[2] / steep[0], 0.62f);  // grey
}

TEST_F(Looks, SnowLiesAboveItsLineAndNotOnCliffs) {
    const GroundOptions snowy = ground("ground = { snow_line = -1000.0 }");
    EXPECT_GT(luminance(mean(ground_albedo(plane(0.2), snowy, 1))), 0.7f);
    EXPECT_LT(luminance(mean(ground_albedo(plane(1.8), snowy, 1))), 0.3f);
    EXPECT_LT(luminance(mean(ground_albedo(plane(0.2), ground(""), 1))), 0.3f);
}

// Under water: neither snow nor grass, and little red where it is deep.
TEST_F(Looks, UnderWaterIsSandThatFadesWithDepth) {
    const GroundOptions snowy = ground("ground = { snow_line = -1000.0 }");
    Terrain terrain = plane(0.1);  // from 63 m in the north to 0
    terrain.water = Field<float>(64, 64, kDry);
    for (int y = 32; y < 64; ++y)
        for (int x = 0; x < 64; ++x) terrain.water(x, y) = 32.0f;
    const Field<Rgb> albedo = ground_albedo(terrain, snowy, 1);
    for (int x = 0; x < 64; ++x) {
        EXPECT_GT(luminance(albedo(x, 10)), 0.7f);
        EXPECT_GT(luminance(albedo(x, 32)), 0.55f * 0.14f);  // wet sand
        EXPECT_LT(luminance(albedo(x, 33)), 0.3f);
        EXPECT_GT(albedo(x, 33)[0], albedo(x, 33)[2]);         // sand
        EXPECT_LT(albedo(x, 45)[0], 0.2f * albedo(x, 45)[1]);  // 14 m down
        EXPECT_LT(luminance(albedo(x, 60)), luminance(albedo(x, 45)));
    }
}

TEST_F(Looks, NoSnowLiesUnderWater) {
    const GroundOptions snowy = ground("ground = { snow_line = -1000.0 }");
    Terrain terrain = plane(0.7);  // steep enough for rock to show through sand
    terrain.water = terrain.heights;
    for (float& level : terrain.water) level += 0.5f;
    for (const Rgb& c : ground_albedo(terrain, snowy, 1)) EXPECT_LT(luminance(c), 0.3f);
}

// A look gives the defaults of the light, and the scene's own tables override them.
TEST_F(Looks, BeginTheLight) {
    const auto render = [&](const std::string& keys) {
        return load(kLeastScene + "[render]\n" + keys).at(0).render;
    };
    EXPECT_EQ(render("look = \"storm\"").sky.turbidity, 3.0);
    EXPECT_EQ(render("look = \"storm\"\nsky = { turbidity = 4.0 }").sky.turbidity, 4.0);
    EXPECT_EQ(render("look = \"storm\"").haze.visibility, metres(60000.0));
    EXPECT_FALSE(render("look = \"moon\"").sky.air);
    EXPECT_EQ(render("look = \"moon\"").fine_relief.craters, 1.0);
    EXPECT_EQ(
        render("look = \"moon\"\nfine_relief = { craters = 0.5 }").fine_relief.craters,
        0.5);
}

// The text of a cache key changes with the bytes of the look.
TEST_F(Looks, FilesArePartOfTheKey) {
    const auto key = [&](const std::string& stone) {
        std::ofstream(folder_ / "mine.toml") << "[[layer]]\nmaterial = \"stone.toml\"\n";
        std::ofstream(folder_ / "stone.toml") << stone;
        return load(kLeastScene + "[render]\nlook = \"mine.toml\"\n").at(0).render_text;
    };
    EXPECT_EQ(key(kStone), key(kStone));
    EXPECT_NE(key(kStone), key(kStone + "bump = 0.5\n"));
}

TEST_F(Looks, ColoursAreAcesCgUnlessNamed) {
    const auto light = [&](const std::string& stone) {
        std::ofstream(folder_ / "mine.toml") << "[[layer]]\nmaterial = \"stone.toml\"\n";
        std::ofstream(folder_ / "stone.toml") << stone;
        return ground("look = \"mine.toml\"").look.materials.at(0).light;
    };
    const std::string red = "light = [0.5, 0.1, 0.1]\ndark = [0.1, 0.1, 0.1]\n";
    EXPECT_EQ(light("space = \"rec709\"\n" + red), (Rgb{0.5f, 0.1f, 0.1f}));
    EXPECT_NEAR(light(red)[0], 0.7820, 1e-3);  // more saturated in the smaller gamut
    EXPECT_NEAR(light(kStone)[2], 0.3, 1e-4);  // grey stays grey
}

TEST_F(Looks, MistakesSayWhereAndWhat) {
    const auto expect = [](const std::string& message, const std::string& part) {
        EXPECT_NE(message.find(part), message.npos) << message;
    };
    expect(complaint(kLeastScene + "[render]\nlook = \"alpin\"\n"),
           "scene.toml:5:8: render.look: no look 'alpin'; did you mean 'alpine'?");
    expect(complaint(kLeastScene + "[render]\nlook = \"nowhere.toml\"\n"),
           "nowhere.toml");
    const std::string earth = "[[layer]]\nmaterial = \"stone.toml\"\n";
    EXPECT_EQ(complaint_of(earth, kStone), "");
    expect(complaint_of("# nothing\n", kStone), "a first [[layer]] without conditions");
    expect(complaint_of(earth + "steeper = [10, 20]\n", kStone), "lies everywhere");
    expect(complaint_of(earth + "[[layer]]\nmaterial = \"snoww\"\n", kStone),
           "mine.toml:4:12: layer[1].material: no material 'snoww'; did you mean 'snow'");
    expect(
        complaint_of(earth + "[[layer]]\nmaterial = \"snow\"\nabove = [5, 5]\n", kStone),
        "mine.toml:5:9: layer[1].above: the first value must be below the second");
    expect(complaint_of(earth + "[[layer]]\nmaterial = \"snow\"\nabove = [5, \"9 %\"]\n",
                        kStone),
           "both shares of the relief");
    expect(
        complaint_of(earth + "[[layer]]\nmaterial = \"snow\"\nsteper = [1, 2]\n", kStone),
        "did you mean 'steeper'?");
    expect(complaint_of(earth, "light = [0.3, 0.3, 2]\ndark = [0, 0, 0]\n"),
           "stone.toml:1:20: light[2]: 2 is out of range");
    expect(complaint_of(earth, "light = [0.3, 0.3]"), "light: expected");
    expect(complaint(kLeastScene +
                     "[render]\nlook = \"mars\"\nground = { snow_line = 5 }\n"),
           "the look 'mars' has no snow");
}

}  // namespace
}  // namespace cydonia::config
