#include "render/passes/passes.h"

#include <OpenImageIO/imageio.h>
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "field/error.h"
#include "field/files.h"
#include "render/cameras/view.h"
#include "render/frames/povray.h"
#include "render/pov/pieces.h"
#include "render/shadow/caster.h"
#include "render/sky/sky.h"
#include "tests/field/temporary_folder.h"
#include "tests/render/no_povray.h"
#include "tests/render/shadow_land.h"

namespace cydonia::render {
namespace {

constexpr int kSide = 96;
constexpr double kSpacing = 20.0;
constexpr double kWidth = kSide * kSpacing;

Terrain flat(float height = 0.0f) {
    Terrain t;
    t.spacing = kSpacing;
    t.heights = Field<float>(kSide, kSide, height);
    return t;
}

// Two hills on a plain that reaches the border, so that no side of the land shows.
Terrain hills() {
    Terrain t = flat();
    t.heights = land(kSide, kSide, kSpacing, [](double x, double y) {
        const double a = std::hypot(x - 0.6 * kWidth, y - 0.55 * kWidth) / kWidth;
        const double b = std::hypot(x - 0.3 * kWidth, y - 0.35 * kWidth) / kWidth;
        const double z =
            500.0 * std::exp(-60.0 * a * a) + 300.0 * std::exp(-90.0 * b * b);
        return z < 2.0 ? 0.0 : z;
    });
    return t;
}

Terrain rough() {
    Terrain t = flat();
    t.heights = fractal(kSide, kSide, 400.0f, 3);
    return t;
}

Camera perspective() {
    Camera c;
    c.eye = {0.4 * kWidth, -0.5 * kWidth, 260.0};
    c.target = {0.52 * kWidth, 0.5 * kWidth, 150.0};
    c.field_of_view = radians(50.0);
    c.width = 160;
    c.height = 90;
    return c;
}

Camera tilted() {
    Camera c = perspective();
    c.projection = Camera::Projection::kOrthographic;
    c.eye = {-0.3 * kWidth, -2.0 * kWidth, 1500.0};
    c.frame_width = 1.1 * kWidth;
    return c;
}

// Straight down, a pixel a cell.
Camera overhead() {
    Camera c;
    c.projection = Camera::Projection::kOrthographic;
    c.eye = {0.5 * kWidth, 0.5 * kWidth, 5000.0};
    c.target = {0.5 * kWidth, 0.5 * kWidth, 0.0};
    c.up = {0.0, 1.0, 0.0};
    c.frame_width = kWidth;
    c.width = c.height = kSide;
    return c;
}

class Quiet final : public Progress {
  public:
    void step(std::string_view) override {}
    void report(double) override {}
    void note(std::string_view) override {}
    void warn(std::string_view) override {}
};

// The land alone as POV-Ray draws it, its colour the share of the way east and north;
// blue 1 where there is any.
Field<Rgb> by_povray(const Camera& camera, const Terrain& terrain) {
    const TemporaryFolder folder;
    const Heights16 heights = quantised(terrain.heights);
    Shot shot;
    shot.name = "shot";
    shot.camera = camera;
    write_png(folder / "heights.png", heights.levels);
    write_text(folder / "shot.ini",
               fmt::format("Input_File_Name=shot.pov\nWidth={}\nHeight={}\n"
                           "Antialias=Off\n",
                           camera.width, camera.height));
    write_text(folder / "shot.pov",
               "#version 3.7; global_settings { assumed_gamma 1 }\n" +
                   pov::land_numbers(heights, terrain.spacing) + pov::camera(shot) +
                   R"(height_field { png "heights.png" gamma 1.0
    scale At(LandWidth - Spacing, LandDepth - Spacing, Relief)
    translate At(Spacing / 2, Spacing / 2, BaseHeight)
    pigment { average pigment_map {
        [1 gradient x color_map { [0 rgb <0, 0, 2>] [1 rgb <2, 0, 2>] } scale LandWidth / Unit]
        [1 gradient z color_map { [0 rgb 0] [1 rgb <0, 2, 0>] } scale LandDepth / Unit]
    } }
    finish { ambient 0 diffuse 0 emission 1 }
})");
    Quiet quiet;
    run_povray(folder.path(), "shot", 2, std::chrono::seconds(60), quiet);
    return read_exr_rgb(folder / "shot.exr");
}

// Pixels on either side of a silhouette, in a mask.
bool near_edge(const Field<std::uint8_t>& mask, int x, int y) {
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i)
            if (mask.contains(i, j) && mask(i, j) != mask(x, y)) return true;
    return false;
}

void expect_aligned(const Camera& camera) {
    if (const auto missing = no_povray()) GTEST_SKIP() << *missing;
    const Terrain terrain = hills();
    const Field<Rgb> frame = by_povray(camera, terrain);
    const CameraRays rays(camera);
    const Field<SeenPoint> points = View(terrain, {}).seen(rays, true);
    Field<std::uint8_t> drawn(frame.width(), frame.height());
    for (std::size_t i = 0; i < drawn.size(); ++i) drawn[i] = frame[i][2] > 0.5f;

    int edge = 0, inner = 0;
    double worst = 0.0;
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x) {
            const bool seen = points(x, y).surface == Surface::kLand;
            if (near_edge(drawn, x, y)) {
                ++edge;
                continue;
            }
            ASSERT_EQ(seen, drawn(x, y) != 0) << x << " " << y;
            if (!seen) continue;
            // Where POV-Ray's point is in our frame.
            const double east = frame(x, y)[0] * kWidth, north = frame(x, y)[1] * kWidth;
            const auto at = rays.project({east, north, ground_at(terrain, east, north)});
            if (std::abs(points(x, y).at[0] - east) > 3 * kSpacing) continue;  // a crest
            worst = std::max(worst, std::hypot(at.x - x - 0.5, at.y - y - 0.5));
            EXPECT_NEAR(points(x, y).depth, at.depth, 0.01 * at.depth);
            ++inner;
        }
    EXPECT_GT(edge, 100);
    EXPECT_GT(inner, 1000);
    EXPECT_LT(worst, 0.35);  // pixels: POV-Ray's half floats are a tenth
}

TEST(Passes, PerspectiveIsAlignedWithPovray) { expect_aligned(perspective()); }
TEST(Passes, OrthographicIsAlignedWithPovray) { expect_aligned(tilted()); }
TEST(Passes, OverheadIsAlignedWithPovray) {
    Camera camera = overhead();
    camera.frame_width = 1.21 * kWidth;
    expect_aligned(camera);
}

TEST(Passes, RaysAndPlacesAreInverse) {
    for (const Camera& camera : {perspective(), tilted(), overhead()}) {
        const CameraRays rays(camera);
        const Ray ray = rays.through(12.25, 70.5);
        const auto at = rays.project(ray.from + 777.0 * ray.direction);
        EXPECT_NEAR(at.x, 12.25, 1e-9);
        EXPECT_NEAR(at.y, 70.5, 1e-9);
        EXPECT_NEAR(at.depth, 777.0 * dot(ray.direction, rays.forward()), 1e-9);
    }
}

TEST(Passes, FromAboveEveryPixelIsItsCell) {
    const Terrain terrain = rough();
    const View view(terrain, {});
    const Field<SeenPoint> points = view.seen(CameraRays(overhead()), false);
    const Field<float>& rounded = view.terrain().heights;
    for (int y = 1; y + 1 < kSide; ++y)
        for (int x = 1; x + 1 < kSide; ++x) {
            const SeenPoint& p = points(x, y);
            ASSERT_EQ(p.surface, Surface::kLand);
            EXPECT_NEAR(p.at[2], rounded(x, y), 0.05);
            EXPECT_NEAR(p.at[0], (x + 0.5) * kSpacing, 0.01);
            EXPECT_NEAR(p.depth, 5000.0 - rounded(x, y), 0.05);
        }
}

TEST(Passes, ShadowIsTheCasters) {
    const Terrain terrain = rough();
    const View view(terrain, {});
    Camera camera = overhead();
    camera.width = camera.height = 2 * kSide;
    const Field<SeenPoint> points = view.seen(CameraRays(camera), false);
    const Sun sun = sun_at(300.0, 20.0);
    const Field<float> seen = view.shadow(points, sun, View::SunAs::kPoint);
    const Mask cast = Caster(view.terrain().heights, kSpacing).shadow(sun, 2);
    ASSERT_GT(area(cast), cast.size() / 10);
    // Every other sample: the rest lie on the squares' diagonals, where a crest's two
    // sides meet.
    int differ = 0;
    for (int y = 2; y + 2 < cast.height(); ++y)
        for (int x = 2 + (y + 1) % 2; x + 2 < cast.width(); x += 2)
            differ += seen(x, y) != float(cast(x, y));
    EXPECT_LT(differ, static_cast<int>(cast.size() / 1000));
}

// Level land seen from above is shaded as the sheet is that the .pov has.
TEST(Passes, CloudsShadeTheLandAsInTheFrame) {
    Terrain terrain = flat();
    terrain.spacing = 200.0;
    Camera camera = overhead();
    camera.eye = {0.5 * terrain.width(), 0.5 * terrain.width(), 5000.0};
    camera.target = {0.5 * terrain.width(), 0.5 * terrain.width(), 0.0};
    camera.frame_width = terrain.width();
    camera.width = camera.height = kSide;
    const Sun sun = sun_at(120.0, 40.0);
    const auto shadow = [&](const Scenery& scenery, const Sun& of) {
        const View view(terrain, scenery);
        return view.shadow(view.seen(CameraRays(camera), false), of, View::SunAs::kPoint);
    };
    Scenery scenery;
    scenery.sky.clouds = Clouds::kBroken;
    const Field<float> shaded = shadow(scenery, sun);
    const Field<float> sheet = cloud_shadows(sun, {}, terrain.width(), kSide);
    EXPECT_GT(*std::ranges::max_element(shaded), 0.5f);
    for (std::size_t i = 0; i < sheet.size(); ++i)
        ASSERT_NEAR(shaded[i], 1.0f - sheet[i], 0.01f);

    const auto none = [](const Field<float>& field) {
        return std::ranges::all_of(field, [](float v) { return v == 0.0f; });
    };
    EXPECT_TRUE(none(shadow(scenery, sun_at(120.0, 2.0))));
    scenery.holds_image = true;
    EXPECT_TRUE(none(shadow(scenery, sun)));
    scenery.sky.cloud_shadows = true;
    EXPECT_FALSE(none(shadow(scenery, sun)));
}

TEST(Passes, PlaneHasItsSlopeAndNormal) {
    Terrain terrain = flat();
    terrain.heights = land(kSide, kSide, kSpacing, [](double x, double) { return x; });
    const View view(terrain, {});
    for (const bool smooth : {false, true}) {
        const Field<SeenPoint> points = view.seen(CameraRays(overhead()), smooth);
        const auto layers =
            passes(view, points, sun_at(90.0, 30.0), {}, {Pass::kSlope, Pass::kNormal});
        ASSERT_EQ(layers.size(), 2u);
        const std::size_t middle = points.index(kSide / 2, kSide / 2);
        EXPECT_NEAR(layers[0].values[middle], 45.0, 0.2);
        EXPECT_NEAR(layers[1].values[3 * middle], -std::sqrt(0.5), 2e-3);
        EXPECT_NEAR(layers[1].values[3 * middle + 1], 0.0, 2e-3);
    }
}

TEST(Passes, WaterIsSeenBeforeItsBed) {
    Terrain terrain = flat();
    terrain.heights = land(kSide, kSide, kSpacing, [](double x, double) { return x; });
    terrain.water = Field<float>(kSide, kSide, kDry);
    for (std::size_t i = 0; i < terrain.heights.size(); ++i)
        if (terrain.heights[i] < 400.0f) terrain.water[i] = 400.0f;
    const Field<SeenPoint> points = View(terrain, {}).seen(CameraRays(overhead()), true);
    EXPECT_EQ(points(5, 40).surface, Surface::kWater);
    EXPECT_NEAR(points(5, 40).at[2], 400.0, 0.1);
    EXPECT_EQ(points(40, 40).surface, Surface::kLand);
    const Field<SeenPoint> flooded = View(hills(), {.flood = WaterOptions{metres(100.0)}})
                                         .seen(CameraRays(overhead()), true);
    EXPECT_EQ(flooded(2, 2).surface, Surface::kWater);
    EXPECT_EQ(flooded(57, 43).surface, Surface::kLand);
}

TEST(Passes, MotionIsWhereThePointGoes) {
    const Field<SeenPoint> points =
        View(hills(), {}).seen(CameraRays(perspective()), true);
    Camera next = perspective();
    next.eye.x += 15.0;
    next.target.x += 40.0;
    const CameraRays now(perspective()), then(next);
    const PassLayer motion = motion_pass(points, now, then);
    int moved = 0;
    for (int y = 0; y < points.height(); ++y)
        for (int x = 0; x < points.width(); ++x) {
            const SeenPoint& p = points(x, y);
            const std::size_t i = 2 * points.index(x, y);
            if (p.surface == Surface::kSky) {
                EXPECT_EQ(motion.values[i], 0.0f);
                continue;
            }
            const auto at = then.project(vec3_of(p.at));
            EXPECT_NEAR(x + 0.5 + motion.values[i], at.x, 0.01 + 1e-3 * std::abs(at.x));
            moved += motion.values[i] < -0.5f;
        }
    EXPECT_GT(moved, 1000);
    for (const float still : motion_pass(points, now, now).values) ASSERT_EQ(still, 0.0f);
}

TEST(Passes, FileHasTheNamesCompositorsExpect) {
    const TemporaryFolder folder;
    const View view(hills(), {});
    const Camera camera = perspective();
    const Field<SeenPoint> points = view.seen(CameraRays(camera), true);
    PassMaps maps{Field<std::uint8_t>(kSide, kSide, 2),
                  Field<std::uint8_t>(kSide, kSide, 3),
                  Field<float>(kSide, kSide, 0.75f)};
    const auto layers =
        passes(view, points, sun_at(300.0, 20.0), maps, values_in(kPasses));
    const Field<Rgb> beauty(camera.width, camera.height, Rgb{0.25f, 0.5f, -0.125f});
    write_passes(folder / "a.exr", beauty, layers, camera.width, camera.height, {});

    const auto in = OIIO::ImageInput::open(folder / "a.exr");
    ASSERT_TRUE(in) << OIIO::geterror();
    const std::vector<std::vector<std::string>> names = {
        {"R", "G", "B"}, {"Z"},       {"P.X", "P.Y", "P.Z"}, {"N.X", "N.Y", "N.Z"},
        {"height.Y"},    {"slope.Y"}, {"material.Y"},        {"type.Y"},
        {"shadow.Y"},    {"sky.Y"}};
    for (std::size_t part = 0; part < names.size(); ++part) {
        const OIIO::ImageSpec spec = in->spec(static_cast<int>(part));
        EXPECT_EQ(spec.channelnames, names[part]);
        EXPECT_EQ(spec.width, camera.width);
        const bool full = part == 1 || part == 2 || part == 4;
        EXPECT_EQ(spec.format, full ? OIIO::TypeFloat : OIIO::TypeHalf) << part;
        if (part == 0) continue;
        std::vector<float> values(layers[part - 1].values.size());
        ASSERT_TRUE(in->read_image(static_cast<int>(part), 0, 0, spec.nchannels,
                                   OIIO::TypeFloat, values.data()));
        for (std::size_t i = 0; i < values.size(); ++i)
            ASSERT_NEAR(values[i], layers[part - 1].values[i],
                        full ? 0.0 : 1e-3 * std::abs(values[i]) + 1e-6);
    }
    EXPECT_EQ(in->spec(static_cast<int>(names.size())).width, 0);
}

TEST(Passes, WithoutTheirDataAreLeftOut) {
    const View view(hills(), {});
    const Field<SeenPoint> points = view.seen(CameraRays(perspective()), true);
    const auto layers = passes(view, points, sun_at(300.0, 20.0), {},
                               {Pass::kMaterial, Pass::kDepth, Pass::kSky});
    ASSERT_EQ(layers.size(), 1u);
    EXPECT_EQ(layers[0].name, "depth");
    EXPECT_EQ(layers[0].values[0], kFarDepth);  // sky
}

TEST(Passes, BadInput) {
    expect_error(ExitCode::kBadRequest, "2x2", [] {
        Terrain t;
        t.heights = Field<float>(1, 5);
        View(t, {});
    });
    expect_error(ExitCode::kBadRequest, "finite", [] {
        Terrain t = flat();
        t.heights(3, 3) = NAN;
        View(t, {});
    });
    expect_error(ExitCode::kBadRequest, "does not fit", [] {
        write_passes("/nonexistent/a.exr", Field<Rgb>(3, 3), {}, 4, 4, {});
    });
}

}  // namespace
}  // namespace cydonia::render
