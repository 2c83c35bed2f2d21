#include "render/cameras/cameras.h"

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

// Lies over the land and looks up: what it looks to is over the land, but not in view.
TEST(LookAt, IntoTheSkyIsRefused) {
    const std::string text = refusal(
        looking({-500.0, 320.0, 9.0}, {320.0, 320.0, 2000.0}), cone(64, 64, 200.0));
    EXPECT_NE(text.find("sees no land: it looks 90.0 degrees clockwise from north and 6"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("change its target so that it looks 90.0 degrees"),
              std::string::npos)
        << text;
}

// Too near and too narrow for any sample of the land to be in the frame.
TEST(LookAt, OneStoneIsLandEnough) {
    CameraOptions o = looking({321.0, 320.0, 0.5}, {321.3, 320.0, 0.0});
    o.field_of_view = radians(1.0);
    EXPECT_EQ(refusal(o, cone(64, 64, 0.0)), "");
}

CameraOptions standing(double east, double north, double heading) {
    CameraOptions c = camera(Kind::kStand);
    c.position = {metres(east), metres(north)};
    c.heading = radians(heading);
    return c;
}

// On the surface that is drawn: squares are split from north-west to south-east.
TEST(Stand, EyesAreAboveTheMesh) {
    Terrain t = cone(64, 64, 0.0);
    t.heights(20, 20) = 130.0f;  // its square's north-west corner
    const double east = 205.0, north = 640.0 - 205.0;
    const auto eye_over = [&](double x, double y) {
        return place(standing(east + x, north - y, 180.0), t, Quality::kDraft).eye.z;
    };
    EXPECT_NEAR(eye_over(0.0, 0.0), 131.8, 1e-4);
    EXPECT_NEAR(eye_over(5.0, 5.0), 116.8, 1e-4);   // on the ridge of the split
    EXPECT_NEAR(eye_over(-5.0, 5.0), 101.8, 1e-4);  // across it: a flat triangle's edge
    EXPECT_NEAR(eye_over(7.0, 1.0), 110.8, 1e-4);
}

TEST(Stand, LooksWhereItsHeadingSays) {
    const Terrain t = cone(64, 64, 200.0);
    for (const double heading : {0.0, 45.0, 90.0, 200.0, 270.0}) {
        CameraOptions o = standing(320.0 - 280.0 * std::sin(radians(heading)),
                                   320.0 - 280.0 * std::cos(radians(heading)), heading);
        const Camera c = place(o, t, Quality::kDraft);
        EXPECT_NEAR(in_frame(c, {320.0, 320.0, 101.8}).x, 0.0, 1e-6) << heading;
        EXPECT_GT(in_frame(c, {320.0, 320.0, 101.8}).z, 200.0) << heading;
        o.pitch = radians(5.0);
        EXPECT_LT(in_frame(place(o, t, Quality::kDraft), {320.0, 320.0, 101.8}).y, 0.0);
    }
}

TEST(Stand, LooksAtTheGroundItMeets) {
    CameraOptions o = standing(320.0, 320.0, 90.0);
    o.pitch = radians(-45.0);
    const Camera c = place(o, cone(64, 64, 0.0), Quality::kDraft);
    EXPECT_NEAR(c.target.x, 321.8, 1e-3);
    EXPECT_NEAR(c.target.z, 100.0, 1e-3);
}

TEST(Stand, OrAtItsTarget) {
    CameraOptions o = standing(100.0, 100.0, 0.0);
    o.looks_at_target = true;
    o.target = {metres(320.0), metres(320.0), metres(0.0)};
    const Camera c = place(o, cone(64, 64, 200.0), Quality::kDraft);
    EXPECT_NEAR(c.target.x, 320.0, 1e-9);
    EXPECT_GT(c.target.z, 280.0);
}

TEST(Stand, AtTheBorderLookingOutIsRefused) {
    const std::string text = refusal(standing(630.0, 320.0, 90.0), cone(64, 64, 200.0));
    EXPECT_NE(text.find("change its heading and pitch so that it looks 270.0 degrees"),
              std::string::npos)
        << text;
}

TEST(Lens, FocalLengthAndSensorAreAFieldOfView) {
    CameraOptions o = camera(Kind::kOrbit);
    o.focal_length = 50.0;
    EXPECT_NEAR(degrees(field_of_view(o)), 39.598, 1e-3);  // 36 mm, as lens tables print
    o.sensor_width = 24.9;
    EXPECT_NEAR(degrees(field_of_view(o)), 27.955, 1e-2);
    const Camera c = place(o, cone(64, 64, 200.0), Quality::kDraft);
    EXPECT_EQ(c.field_of_view, field_of_view(o));
    EXPECT_EQ(c.aperture, 0.0);
}

TEST(Lens, OpeningIsFocalLengthOverItsStop) {
    CameraOptions o = looking({100.0, 100.0, 5.0}, {400.0, 500.0, 5.0});
    o.f_stop = 2.0;
    o.focal_length = 50.0;
    const Terrain t = cone(64, 64, 0.0);
    EXPECT_NEAR(place(o, t, Quality::kDraft).aperture, 0.025, 1e-12);
    EXPECT_NEAR(place(o, t, Quality::kDraft).focus_distance, 500.0, 1e-6);
    o.focal_length.reset();
    o.field_of_view = 2.0 * std::atan(0.5);  // as wide as the sensor at its distance
    EXPECT_NEAR(place(o, t, Quality::kDraft).aperture, 0.018, 1e-12);
}

TEST(Lens, FocusIsADistanceAlongTheViewOrAPoint) {
    CameraOptions o = looking({100.0, 100.0, 5.0}, {500.0, 100.0, 5.0});
    o.f_stop = 2.0;
    const Terrain t = cone(64, 64, 0.0);
    o.focus_distance = metres(12.0);
    EXPECT_NEAR(place(o, t, Quality::kDraft).focus_distance, 12.0, 1e-9);
    o.focus_distance.reset();
    o.focus = {metres(130.0), metres(170.0), metres(0.0)};  // aside of the view
    EXPECT_NEAR(place(o, t, Quality::kDraft).focus_distance, 30.0, 1e-9);
    o.focus = {metres(60.0), metres(100.0), metres(0.0)};
    const std::string text = refusal(o, t);
    EXPECT_NE(text.find("is focused 40 m behind itself: move its focus"),
              std::string::npos)
        << text;
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
    EXPECT_NE(refusal(low, flooded(130.0f)).find("stands 5 m under the water: raise"),
              std::string::npos);
    EXPECT_NE(refusal(low, flooded(80.0f)).find("stands 5 m under the ground: raise"),
              std::string::npos);
}

TEST(Cameras, StandAboveTheFlood) {
    const WaterOptions flood{metres(150.0)};
    const Terrain t = cone(64, 64, 200.0);
    const CameraOptions o = looking({20.0, 320.0, 5.0}, {320.0, 320.0, 0.0});
    EXPECT_NEAR(place(o, t, Quality::kDraft).eye.z, 105.0, 1e-3);
    EXPECT_NEAR(place(o, t, Quality::kDraft, flood).eye.z, 155.0, 1e-3);
}

// Level country as low as the land's lowest border lies around it.
TEST(Cameras, BelowTheOutskirtsIsRefused) {
    Terrain bowl = cone(64, 64, -4000.0);
    CameraOptions o = camera(Kind::kOrbit);
    o.elevation = radians(5.0);
    EXPECT_NE(refusal(o, bowl).find("under the ground: raise its elevation"),
              std::string::npos)
        << refusal(o, bowl);
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
