#include "render/cameras.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "field/error.h"

namespace cydonia::render {
namespace {

using Kind = CameraOptions::Kind;

// A cone of `height` metres on level ground.
Terrain cone(int width, int depth, double height) {
    Terrain t;
    t.spacing = 10.0;
    t.heights = Field<float>(width, depth, 100.0f);
    const double radius = 0.4 * std::min(width, depth);
    for (int y = 0; y < depth; ++y)
        for (int x = 0; x < width; ++x) {
            const double d = std::hypot(x + 0.5 - 0.5 * width, y + 0.5 - 0.5 * depth);
            t.heights(x, y) +=
                static_cast<float>(height * std::max(0.0, 1.0 - d / radius));
        }
    return t;
}

CameraOptions camera(Kind kind, int width = 1920, int height = 1080) {
    CameraOptions c;
    c.name = "shot";
    c.kind = kind;
    c.size = {width, height};
    return c;
}

CameraOptions looking(std::array<double, 3> eye, std::array<double, 3> target) {
    CameraOptions c = camera(Kind::kLookAt);
    for (std::size_t i = 0; i < 3; ++i) {
        c.eye[i] = metres(eye[i]);
        c.target[i] = metres(target[i]);
    }
    return c;
}

// Where a point lands in the frame, -1 to 1 rightwards and upwards; and how far ahead.
Vec3 in_frame(const Camera& c, const Vec3& p) {
    const Vec3 forward = normalized(c.target - c.eye);
    const Vec3 right = normalized(cross(forward, c.up)), up = cross(right, forward);
    const Vec3 d = p - c.eye;
    const double aspect = static_cast<double>(c.width) / c.height;
    const double half = c.projection == Camera::Projection::kOrthographic
                            ? 0.5 * c.frame_width
                            : std::tan(0.5 * c.field_of_view) * dot(d, forward);
    return {dot(d, right) / half, dot(d, up) / half * aspect, dot(d, forward)};
}

std::string refusal(const CameraOptions& options, const Terrain& terrain) {
    try {
        place(options, terrain, Quality::kDraft);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::kBadRequest);
        return e.what();
    }
    return "";
}

TEST(Overhead, CoversTheMeshExactly) {
    const Terrain t = cone(64, 64, 200.0);
    const Camera c = place(camera(Kind::kOverhead, 1080, 1080), t, Quality::kFinal);
    EXPECT_EQ(c.projection, Camera::Projection::kOrthographic);
    const Vec3 north_west = in_frame(c, {5.0, 635.0, 100.0});
    EXPECT_NEAR(north_west.x, -1.0, 1e-9);
    EXPECT_NEAR(north_west.y, 1.0, 1e-9);
    const Vec3 south_east = in_frame(c, {635.0, 5.0, 300.0});
    EXPECT_NEAR(south_east.x, 1.0, 1e-9);
    EXPECT_NEAR(south_east.y, -1.0, 1e-9);
}

TEST(Overhead, LongLandFitsEveryFrame) {
    for (const auto& [land_width, land_depth] : {std::pair{96, 32}, std::pair{32, 96}})
        for (const auto& [width, height] : {std::pair{800, 800}, std::pair{1600, 400}}) {
            const Terrain t = cone(land_width, land_depth, 200.0);
            const Camera c =
                place(camera(Kind::kOverhead, width, height), t, Quality::kFinal);
            const Vec3 corner = in_frame(c, {t.width() - 5.0, t.depth() - 5.0, 100.0});
            EXPECT_NEAR(std::max(corner.x, corner.y), 1.0, 1e-9);
            EXPECT_LE(std::min(corner.x, corner.y), 1.0 + 1e-9);
        }
}

TEST(Oblique, StandsWhereItsAzimuthSays) {
    const Terrain t = cone(64, 64, 200.0);
    CameraOptions o = camera(Kind::kOblique);
    o.azimuth = radians(90.0);
    EXPECT_GT(place(o, t, Quality::kDraft).eye.x, t.width());
    o.azimuth = radians(180.0);
    EXPECT_LT(place(o, t, Quality::kDraft).eye.y, 0.0);
}

// Every azimuth and frame: the peak is in view, and below the frame's lower edge ends the
// land's near edge.
TEST(Oblique, LandFillsTheFrame) {
    const Terrain t = cone(64, 64, 200.0);
    for (const auto& [width, height] : {std::pair{1920, 1080}, std::pair{900, 900}})
        for (const double elevation : {6.0, 12.0, 20.0, 45.0})
            for (double azimuth = 0.0; azimuth < 360.0; azimuth += 90.0) {
                CameraOptions o = camera(Kind::kOblique, width, height);
                o.azimuth = radians(azimuth);
                o.elevation = radians(elevation);
                const Camera c = place(o, t, Quality::kFinal);
                const Vec3 peak = in_frame(c, {320.0, 320.0, 300.0});
                EXPECT_LE(std::abs(peak.x), 1e-6);
                EXPECT_LE(std::abs(peak.y), 1.0);
                const Vec3 near = in_frame(c, Vec3{320.0, 320.0, 100.0} +
                                                  320.0 * direction_to({o.azimuth, 0.0}));
                EXPECT_LE(near.y, -0.9) << azimuth << " " << elevation;
            }
}

TEST(Oblique, FarSideIsAsWideAsTheFrame) {
    const Terrain t = cone(64, 64, 0.0);
    const Camera c = place(camera(Kind::kOblique), t, Quality::kFinal);
    EXPECT_NEAR(in_frame(c, {640.0, 640.0, 100.0}).x, 1.0, 0.02);
}

TEST(Orbit, TheWholeLandIsInViewFromEverySide) {
    const Terrain t = cone(96, 48, 100.0);
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 30.0) {
        CameraOptions o = camera(Kind::kOrbit);
        o.azimuth = radians(azimuth);
        const Camera c = place(o, t, Quality::kFinal);
        for (const double x : {0.0, t.width()})
            for (const double y : {0.0, t.depth()})
                EXPECT_LE(std::abs(in_frame(c, {x, y, 100.0}).x), 1.0);
    }
}

TEST(Orbit, KeepsItsDistance) {
    const Terrain t = cone(64, 64, 100.0);
    CameraOptions o = camera(Kind::kOrbit);
    o.distance = of_width(2.0);
    const Camera c = place(o, t, Quality::kFinal);
    EXPECT_NEAR(length(c.eye - c.target), 1280.0, 1e-6);
    EXPECT_NEAR(c.target.x, 320.0, 1e-9);
}

TEST(Orbit, InsideTheHillIsRefused) {
    CameraOptions o = camera(Kind::kOrbit);
    o.distance = metres(60.0);
    o.elevation = radians(3.0);
    EXPECT_NE(refusal(o, cone(64, 64, 500.0)).find("under the ground"),
              std::string::npos);
}

TEST(LookAt, HeightsAreAboveTheGroundThere) {
    const Terrain t = cone(65, 65, 200.0);
    const Camera c =
        place(looking({325.0, 325.0, 5.0}, {5.0, 5.0, 2.0}), t, Quality::kFinal);
    EXPECT_NEAR(c.eye.z, 305.0, 1e-3);
    EXPECT_NEAR(c.target.z, 102.0, 1e-3);
}

TEST(LookAt, StraightDownHasNorthUp) {
    const Camera c = place(looking({320.0, 320.0, 500.0}, {320.0, 320.0, 0.0}),
                           cone(64, 64, 200.0), Quality::kFinal);
    EXPECT_EQ(c.up, (Vec3{0.0, 1.0, 0.0}));
}

TEST(LookAt, UnderTheGroundIsRefused) {
    const std::string text =
        refusal(looking({320.0, 320.0, -3.0}, {5.0, 5.0, 2.0}), cone(64, 64, 200.0));
    EXPECT_NE(text.find("camera 'shot' stands 3 m under the ground"), std::string::npos)
        << text;
}

TEST(LookAt, OnePointIsRefused) {
    EXPECT_NE(
        refusal(looking({320.0, 320.0, 9.0}, {320.0, 320.0, 9.0}), cone(64, 64, 200.0)),
        "");
}

TEST(LookAt, AwayFromTheLandIsRefused) {
    const std::string text =
        refusal(looking({-500.0, 320.0, 9.0}, {-900.0, 320.0, 9.0}), cone(64, 64, 200.0));
    EXPECT_NE(text.find("sees no land"), std::string::npos) << text;
}

TEST(LookAt, PastTheLandButOverItIsFine) {
    EXPECT_EQ(
        refusal(looking({-500.0, 320.0, 90.0}, {900.0, 320.0, 9.0}), cone(64, 64, 200.0)),
        "");
}

// A sea over level land at 100 m.
Terrain flooded(float level) {
    Terrain t = cone(64, 64, 0.0);
    t.water = Field<float>(64, 64, level);
    return t;
}

TEST(Cameras, StandAboveWater) {
    const CameraOptions o = looking({100.0, 320.0, 5.0}, {600.0, 320.0, 0.0});
    EXPECT_NEAR(place(o, flooded(130.0f), Quality::kDraft).eye.z, 135.0, 1e-3);
    EXPECT_NEAR(place(o, flooded(80.0f), Quality::kDraft).eye.z, 105.0, 1e-3);
    const CameraOptions low = looking({100.0, 320.0, -5.0}, {600.0, 320.0, 0.0});
    EXPECT_NE(refusal(low, flooded(130.0f)), "");
}

TEST(Size, FollowsTheQuality) {
    const Terrain t = cone(16, 16, 10.0);
    const CameraOptions o = camera(Kind::kOverhead, 1920, 1080);
    EXPECT_EQ(place(o, t, Quality::kDraft).width, 640);
    EXPECT_EQ(place(o, t, Quality::kDraft).height, 360);
    EXPECT_EQ(place(o, t, Quality::kPreview).width, 1280);
    EXPECT_EQ(place(o, t, Quality::kFinal).width, 1920);
    EXPECT_EQ(place(camera(Kind::kOverhead, 20, 16), t, Quality::kDraft).height, 16);
}

TEST(DefaultCameras, AreAMapAndAView) {
    const auto cameras = default_cameras();
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].kind, Kind::kOverhead);
    EXPECT_EQ(cameras[1].kind, Kind::kOblique);
    for (const CameraOptions& c : cameras) EXPECT_EQ(refusal(c, cone(64, 64, 900.0)), "");
}

TEST(Cameras, SmallestLand) {
    Terrain t;
    t.heights = Field<float>(2, 2, 0.0f);
    for (const Kind kind : {Kind::kOverhead, Kind::kOblique, Kind::kOrbit})
        EXPECT_EQ(refusal(camera(kind), t), "");
}

}  // namespace
}  // namespace cydonia::render
