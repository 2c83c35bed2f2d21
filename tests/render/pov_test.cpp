// The .pov as text against tests/golden/pov/, and as POV-Ray takes it. After a change
// that is meant, CYDONIA_UPDATE_GOLDEN=1 in the environment writes the golden files anew.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

#include "field/error.h"
#include "field/files.h"
#include "field/image.h"
#include "render/cameras/cameras.h"
#include "render/frames/povray.h"
#include "render/pov/scene.h"
#include "render/scene/files.h"
#include "tests/field/temporary_folder.h"
#include "tests/render/no_povray.h"

namespace cydonia::render {
namespace {

namespace fs = std::filesystem;
using Kind = CameraOptions::Kind;

constexpr int kSide = 64;
constexpr double kSpacing = 20.0;

Terrain hill(int side = kSide) {
    Terrain t;
    t.spacing = kSpacing;
    t.heights = Field<float>(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double d = std::hypot(x - 0.6 * side, y - 0.4 * side) / side;
            t.heights(x, y) =
                static_cast<float>(std::lround(1e3 * std::exp(-8.0 * d * d)));
        }
    return t;
}

CameraOptions options_of(Kind kind) {
    CameraOptions c;
    c.name = "shot";
    c.kind = kind;
    c.size = {64, 64};
    c.eye = {metres(300.0), metres(100.0), metres(50.0)};
    c.target = {metres(700.0), metres(800.0), metres(10.0)};
    return c;
}

Shot shot_of(Kind kind, Quality quality) {
    Shot shot;
    shot.title = "A hill";
    shot.name = "shot";
    shot.sun = {radians(305.0), radians(25.0)};
    shot.quality = quality;
    shot.camera = place(options_of(kind), hill(), Quality::kFinal);
    return shot;
}

std::string text_of(const Shot& shot) {
    return pov_scene(shot, quantised(hill().heights), kSpacing);
}

void expect_golden(const std::string& name, const std::string& text) {
    const fs::path file =
        fs::path(CYDONIA_SOURCE_DIR) / "tests/golden/pov" / (name + ".pov");
    const char* update = std::getenv("CYDONIA_UPDATE_GOLDEN");
    if (update && std::string(update) == "1") write_text(file, text);
    EXPECT_EQ(text, read_text(file)) << "meant? CYDONIA_UPDATE_GOLDEN=1 accepts it";
}

TEST(PovScene, OverheadDraft) {
    expect_golden("overhead_draft", text_of(shot_of(Kind::kOverhead, Quality::kDraft)));
}
TEST(PovScene, ObliquePreview) {
    expect_golden("oblique_preview", text_of(shot_of(Kind::kOblique, Quality::kPreview)));
}
TEST(PovScene, OrbitDraftWithoutHaze) {
    Shot shot = shot_of(Kind::kOrbit, Quality::kDraft);
    shot.options.haze.visibility = metres(0.0);
    expect_golden("orbit_draft_clear", text_of(shot));
}
TEST(PovScene, LookAtFinalWithWater) {
    Shot shot = shot_of(Kind::kLookAt, Quality::kFinal);
    shot.options.water = WaterOptions{metres(60.0)};
    expect_golden("look_at_final_water", text_of(shot));
}

// The hill with a lake 500 m up, west of its top, and a sea in the south.
Terrain wet_hill() {
    Terrain t = hill();
    t.water = Field<float>(kSide, kSide, kDry);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            if (y >= 56) t.water(x, y) = 20.0f;
            if (std::hypot(x - 20, y - 24) < 5.0) t.water(x, y) = 500.0f;
            if (t.water(x, y) != kDry) t.heights(x, y) = t.water(x, y) - 8.0f;
        }
    return t;
}

TEST(PovScene, ObliqueDraftOfSeaAndLake) {
    const Terrain t = wet_hill();
    Shot shot = shot_of(Kind::kOblique, Quality::kDraft);
    shot.camera = place(options_of(Kind::kOblique), t, Quality::kFinal);
    expect_golden("oblique_draft_waters",
                  pov_scene(shot, quantised(t.heights), kSpacing, water_surface(t)));
}

TEST(WaterSurface, IsAtItsLevelsAndUnderTheLandBesideThem) {
    const Terrain t = wet_hill();
    const auto surface = water_surface(t);
    ASSERT_TRUE(surface);
    EXPECT_EQ(surface->sea, 20.0);
    const Field<float> heights = heights_of(surface->heights);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            if (t.water(x, y) != kDry) {
                EXPECT_NEAR(heights(x, y), t.water(x, y), 0.02f) << x << " " << y;
            } else {
                EXPECT_LT(heights(x, y), t.heights(x, y)) << x << " " << y;
            }
        }
    // North of the sea the land is higher than it: the surface goes on into it.
    ASSERT_GT(t.heights(38, 55), 100.0f);
    EXPECT_NEAR(heights(38, 55), 20.0f, 0.02f);
    EXPECT_EQ(surface->heights.levels(38, 53), 0);
}

TEST(WaterSurface, NoneWithoutWaterOrUnderTheLand) {
    EXPECT_FALSE(water_surface(hill()));
    Terrain t = hill();
    t.water = Field<float>(kSide, kSide, kDry);
    EXPECT_FALSE(water_surface(t));
    t.water = Field<float>(kSide, kSide, -10.0f);
    EXPECT_FALSE(water_surface(t));
}

TEST(WaterSurface, ALakeIsNoSea) {
    Terrain t = wet_hill();
    for (int y = 56; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) t.water(x, y) = kDry;
    ASSERT_TRUE(water_surface(t));
    EXPECT_FALSE(water_surface(t)->sea);
}

TEST(PovScene, FillChangesOneNumber) {
    Shot shot = shot_of(Kind::kOblique, Quality::kDraft);
    shot.options.sky.fill = 1.0;
    std::string once = text_of(shot);
    shot.options.sky.fill = 2.0;
    const std::string twice = text_of(shot);
    once.replace(once.find("SkyFill      = 1"), 16, "SkyFill      = 2");
    EXPECT_EQ(once, twice);
}

// What may come in a title, on one line and never outside the comment.
const std::string kHostileTitles[] = {
    "\"quotes\" and 'more'",
    "two\nlines\r\n#error \"out\"",
    "*/ #error \"out\" /*",
    "// /* never closed",
    "back\\slash \\",
    std::string("nul \0 bell \a escape \x1b[31m", 24),
    "Z\xc3\xbcrich \xe5\xb1\xb1",
    "broken \xff\xfe utf-8",
    "{0} {} %s #declare LandWidth = 1;",
};

TEST(PovScene, TitlesStayInTheComment) {
    const std::string plain = text_of(shot_of(Kind::kOblique, Quality::kDraft));
    const std::string rest = plain.substr(plain.find('\n'));
    for (const std::string& title : kHostileTitles) {
        Shot shot = shot_of(Kind::kOblique, Quality::kDraft);
        shot.title = title;
        const std::string text = text_of(shot);
        EXPECT_EQ(text.substr(text.find('\n')), rest) << title;
        EXPECT_TRUE(text.starts_with("// "));
        EXPECT_TRUE(std::none_of(text.begin(), text.end(), [](unsigned char c) {
            return (c < 0x20 && c != '\n') || c == 0x7f;
        })) << title;
    }
}

// Who takes a .pov elsewhere must know what to take with it.
TEST(PovScene, NamesEveryFileThatItNeeds) {
    const TemporaryFolder folder;
    Shot shot = shot_of(Kind::kOblique, Quality::kDraft);
    shot.options.sky.clouds = Clouds::kBroken;
    shot.options.things.push_back({.density = 0.2});
    const std::vector<std::string> written = write_pov_scene(folder.path(), shot, hill());
    const std::string text = read_text(folder / "shot.pov");
    const std::string header = text.substr(0, text.find("#version"));
    EXPECT_EQ(written.size(), 5u);
    for (const std::string& name : written) {
        EXPECT_TRUE(name == "shot.pov" || header.find(name) != std::string::npos) << name;
        EXPECT_TRUE(std::ranges::any_of(values_in(kShotFiles), [&](ShotFile file) {
            return name == file_of("shot", file);
        })) << name;
    }
    for (std::size_t at = text.find(".png"); at != std::string::npos;
         at = text.find(".png", at + 1)) {
        const std::size_t begin = text.find_last_of(" \"", at) + 1;
        EXPECT_NE(header.find(text.substr(begin, at + 4 - begin)), std::string::npos);
    }
}

// A file is one shot's or the land's, whatever the cameras are called.
TEST(PovScene, NoTwoShotsWriteOneFile) {
    std::vector<std::string> files;
    for (const std::string camera :
         {"a", "sky_a", "a_sky", "clouds_a", "things_a", "land-a", "materials", "heights",
          "ground", "sky_visibility", "water", "a-s001", "a_s001", "s001", "part"})
        for (const std::string& shot :
             {camera, moment_name(camera, 1), moment_name(camera, 12),
              moment_name(camera, 1000)})
            for (const ShotFile file : values_in(kShotFiles)) {
                EXPECT_TRUE(is_shot_name(shot)) << shot;
                files.push_back(file_of(shot, file));
            }
    const Terrain land = wet_hill();
    const TemporaryFolder folder;
    std::ranges::copy(
        write_pov_assets(folder.path(), land, land_maps(land, {}, Quality::kDraft)),
        std::back_inserter(files));
    std::ranges::sort(files);
    const auto twice = std::ranges::adjacent_find(files);
    EXPECT_EQ(twice, files.end()) << (twice == files.end() ? "" : *twice);
}

TEST(PovScene, NamesThatAreNotNames) {
    Shot shot = shot_of(Kind::kOblique, Quality::kDraft);
    for (const char* name : {"", "a b", "../up", "a\"", "a\nb", "a;b", "a.b", "a.s",
                             ".s1", "a.s1.s2", "a.sky"}) {
        shot.name = name;
        EXPECT_THROW(text_of(shot), Error) << name;
    }
}

class PovFolder : public testing::Test {
  protected:
    void SetUp() override {
        if (const auto missing = no_povray()) GTEST_SKIP() << *missing;
    }
    void write(const Shot& shot, const Terrain& terrain) {
        write_pov_assets(folder_.path(), terrain,
                         land_maps(terrain, shot.options.ground, shot.quality));
        write_pov_scene(folder_.path(), shot, terrain);
    }
    Field<Rgb> render(const Shot& shot, int threads = 2) {
        SilentProgress progress;
        run_povray(folder_.path(), shot.name, threads, std::chrono::minutes(2), progress);
        return read_exr_rgb(folder_ / (shot.name + ".exr"));
    }
    Field<Rgb> rendered(const Shot& shot, const Terrain& terrain, int threads = 2) {
        write(shot, terrain);
        return render(shot, threads);
    }

    TemporaryFolder folder_;
};

float brightest(const Field<Rgb>& frame) {
    float result = 0.0f;
    for (const Rgb& p : frame) result = std::max({result, p[0], p[1], p[2]});
    return result;
}

double mean(const Field<Rgb>& frame) {
    double sum = 0.0;
    for (const Rgb& p : frame) sum += p[0] + p[1] + p[2];
    return sum / (3.0 * static_cast<double>(frame.size()));
}

TEST_F(PovFolder, EveryKindAndQualityRendersWithoutAWarning) {
    write_pov_assets(folder_.path(), hill(),
                     land_maps(hill(), GroundOptions(), Quality::kFinal));
    for (const Kind kind : {Kind::kOverhead, Kind::kOblique, Kind::kOrbit, Kind::kLookAt})
        for (const Quality quality :
             {Quality::kDraft, Quality::kPreview, Quality::kFinal}) {
            Shot shot = shot_of(kind, quality);
            if (kind == Kind::kLookAt) shot.options.water = WaterOptions{metres(60.0)};
            write_pov_scene(folder_.path(), shot, hill());
            const fs::path ini = folder_ / "shot.ini";
            write_text(ini, read_text(ini) + "Warning_File=warnings.txt\n");
            const Field<Rgb> frame = render(shot);
            EXPECT_EQ(frame.width(), 64);
            EXPECT_EQ(frame.height(), 64);
            EXPECT_GT(brightest(frame), 0.01f);
            const std::string warnings = read_text(folder_ / "warnings.txt");
            EXPECT_EQ(warnings.find("Parse Warning"), std::string::npos) << warnings;
        }
}

TEST_F(PovFolder, HostileTitlesParse) {
    Shot shot = shot_of(Kind::kOverhead, Quality::kDraft);
    const Field<Rgb> plain = rendered(shot, hill());
    for (const std::string& title : kHostileTitles) {
        shot.title = title;
        write_text(folder_ / "shot.pov", text_of(shot));
        EXPECT_EQ(render(shot), plain) << title;
    }
}

TEST_F(PovFolder, DraftsAreEqualWithOneThreadAndFour) {
    const Shot shot = shot_of(Kind::kOblique, Quality::kDraft);
    const Field<Rgb> one = rendered(shot, hill(), 1);
    EXPECT_EQ(render(shot, 4), one);
}

// From straight above, a pixel a cell: the whole extent, the mesh's rim included.
Shot map_shot() {
    Shot shot = shot_of(Kind::kOverhead, Quality::kDraft);
    shot.camera.frame_width = kSide * kSpacing;
    return shot;
}

// Cell by cell: what is painted at a cell of ground.png is seen in that cell's pixel of
// the overhead frame, and only there.
TEST_F(PovFolder, GroundImageLiesOnItsCells) {
    Terrain flat;
    flat.spacing = kSpacing;
    flat.heights = Field<float>(kSide, kSide, 0.0f);
    const Shot shot = map_shot();
    write(shot, flat);
    Field<Rgb8> ground(kSide, kSide);
    ground(20, 9) = {255, 255, 255};
    write_png(folder_ / "ground.png", ground);
    const Field<Rgb> frame = render(shot);
    const float white = frame(20, 9)[1];
    EXPECT_GT(white, 0.1f);
    for (int y = 1; y < kSide - 1; ++y)
        for (int x = 1; x < kSide - 1; ++x) {
            const bool here = x == 20 && y == 9;
            EXPECT_EQ(frame(x, y)[1] > 0.02f * white, here) << x << " " << y;
        }
}

// The six triangles around a height are seen around its cell's centre.
TEST_F(PovFolder, HeightsLieOnTheirCells) {
    Terrain bump;
    bump.spacing = kSpacing;
    bump.heights = Field<float>(kSide, kSide, 0.0f);
    bump.heights(20, 9) = 10.0f;
    Shot shot = map_shot();
    shot.camera.width = shot.camera.height = 4 * kSide;
    shot.sun = {radians(250.0), radians(45.0)};
    shot.options.sky.fill = 0.0;
    write(shot, bump);
    write_png(folder_ / "ground.png", Field<Rgb8>(kSide, kSide, {128, 128, 128}));
    const Field<Rgb> frame = render(shot);
    const float flat = frame(160, 160)[1];
    double east = 0.0, south = 0.0, count = 0.0;
    for (int y = 8; y < frame.height() - 8; ++y)
        for (int x = 8; x < frame.width() - 8; ++x)
            if (std::abs(frame(x, y)[1] - flat) > 0.01f * flat) {
                east += x + 0.5;
                south += y + 0.5;
                count += 1.0;
            }
    ASSERT_GT(count, 20.0);
    EXPECT_NEAR(east / count / 4.0, 20.5, 0.1);
    EXPECT_NEAR(south / count / 4.0, 9.5, 0.1);
}

// Seen from above, water has no edge beyond its shore and no hole within it.
TEST_F(PovFolder, WaterLiesOnItsCells) {
    Terrain t;
    t.spacing = kSpacing;
    t.heights = Field<float>(kSide, kSide, 3.0f);
    t.water = Field<float>(kSide, kSide, kDry);
    for (int y = 20; y < 30; ++y)
        for (int x = 8; x < 40; ++x) t.water(x, y) = 2.0f, t.heights(x, y) = -40.0f;
    const Shot shot = map_shot();
    write(shot, t);
    write_png(folder_ / "ground.png", Field<Rgb8>(kSide, kSide, {255, 255, 255}));
    const Field<Rgb> frame = render(shot);
    const float dry = frame(50, 50)[0];
    for (int y = 1; y < kSide - 1; ++y)
        for (int x = 1; x < kSide - 1; ++x) {
            const bool at_shore = x >= 7 && x <= 40 && y >= 19 && y <= 30 &&
                                  (x <= 8 || x >= 39 || y <= 20 || y >= 29);
            if (at_shore) continue;
            if (t.water(x, y) != kDry) {
                EXPECT_LT(frame(x, y)[0], 0.85f * frame(50, 50)[0]) << x << " " << y;
            } else {
                EXPECT_NEAR(frame(x, y)[0], dry, 0.02f * dry) << x << " " << y;
            }
        }
}

// A white sheet on level ground sends back the sun's colour times the sine of its
// elevation: the image's gamma, the light's unit and the pixels' scale are right.
TEST_F(PovFolder, WhiteGroundSendsBackTheSun) {
    Terrain flat;
    flat.spacing = kSpacing;
    flat.heights = Field<float>(kSide, kSide, 0.0f);
    Shot shot = shot_of(Kind::kOverhead, Quality::kDraft);
    shot.options.sky.fill = 0.0;
    write(shot, flat);
    write_png(folder_ / "ground.png", Field<Rgb8>(kSide, kSide, {255, 255, 255}));
    const double white = render(shot)(40, 40)[1];
    const std::string text = text_of(shot);
    const std::size_t at = text.find("SunLight     = rgb <");
    const std::string green = text.substr(text.find(", ", at) + 2);
    EXPECT_NEAR(white, std::stod(green) * std::sin(shot.sun.elevation), 2e-3);
    write_png(folder_ / "ground.png", Field<Rgb8>(kSide, kSide, {128, 128, 128}));
    EXPECT_NEAR(render(shot)(40, 40)[1] / white, 0.2158, 1e-3);  // sRGB 128, decoded
}

TEST_F(PovFolder, SkyIsBrightestAroundTheSun) {
    Shot shot = shot_of(Kind::kLookAt, Quality::kDraft);
    shot.sun = {radians(60.0), radians(20.0)};
    shot.options.haze.visibility = metres(0.0);
    Terrain flat;
    flat.spacing = kSpacing;
    flat.heights = Field<float>(kSide, kSide, 0.0f);
    write(shot, flat);
    const auto towards = [&](double azimuth) {
        shot.camera.eye = {640.0, 640.0, 100.0};
        shot.camera.target = shot.camera.eye +
                             100.0 * direction_to({radians(azimuth), shot.sun.elevation});
        write_text(folder_ / "shot.pov",
                   pov_scene(shot, quantised(flat.heights), kSpacing));
        return mean(render(shot));
    };
    const double sunward = towards(60.0);
    for (const double azimuth : {0.0, 120.0, 240.0, 300.0})
        EXPECT_GT(sunward, 1.2 * towards(azimuth)) << azimuth;
}

}  // namespace
}  // namespace cydonia::render
