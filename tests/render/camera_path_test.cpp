#include "render/cameras/path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "field/error.h"
#include "render/cameras/cameras.h"

namespace cydonia::render {
namespace {

const std::vector<double> kTimes{0.0, 10.0, 14.0, 40.0, 41.0};
const std::vector<Vec3> kPoints{
    {0, 0, 0}, {100, 20, 5}, {110, 22, 5}, {100, 300, 90}, {0, 310, 90}};

double apart(const Vec3& a, const Vec3& b) { return length(a - b); }

TEST(TimedCurve, PassesThroughItsPointsAtTheirTimes) {
    for (const bool eased : {true, false}) {
        const TimedCurve curve(kTimes, kPoints, eased);
        for (std::size_t i = 0; i < kTimes.size(); ++i)
            EXPECT_LT(apart(curve(kTimes[i]), kPoints[i]), 1e-9) << i;
    }
}

TEST(TimedCurve, StaysAtItsEnds) {
    const TimedCurve curve(kTimes, kPoints, false);
    EXPECT_EQ(curve(-100.0), kPoints.front());
    EXPECT_EQ(curve(1e9), kPoints.back());
}

// No jump of the velocity anywhere, the points' own times included.
TEST(TimedCurve, HasOneVelocityOnBothSidesOfEveryMoment) {
    const TimedCurve curve(kTimes, kPoints, true);
    const double h = 1e-5;
    for (double t = 0.5; t < 41.0; t += 0.5) {
        const Vec3 before = (1.0 / h) * (curve(t) - curve(t - h));
        const Vec3 after = (1.0 / h) * (curve(t + h) - curve(t));
        EXPECT_LT(apart(before, after), 1e-2 + 2e-3 * length(before)) << t;
    }
}

TEST(TimedCurve, EasedEndsAreAtRest) {
    const double h = 1e-3;
    const auto speeds = [&](bool eased) {
        const TimedCurve curve(kTimes, kPoints, eased);
        return std::pair{apart(curve(h), curve(0.0)) / h,
                         apart(curve(41.0), curve(41.0 - h)) / h};
    };
    EXPECT_LT(speeds(true).first, 0.01);
    EXPECT_LT(speeds(true).second, 0.5);
    EXPECT_GT(speeds(false).first, 5.0);
    EXPECT_GT(speeds(false).second, 50.0);
}

// Evenly keyed points of a line are passed at one speed.
TEST(TimedCurve, ALineIsALine) {
    const TimedCurve curve({0, 1, 2, 3}, {{0, 0, 0}, {2, 1, 0}, {4, 2, 0}, {6, 3, 0}},
                           false);
    for (double t = 0.0; t <= 3.0; t += 0.125)
        EXPECT_LT(apart(curve(t), {2 * t, t, 0}), 1e-9) << t;
}

TEST(TimedCurve, APointGivenTwiceIsARest) {
    const TimedCurve curve({0, 10, 20, 30},
                           {{0, 0, 0}, {50, 0, 0}, {50, 0, 0}, {50, 80, 0}}, true);
    for (double t = 10.0; t <= 20.0; t += 1.0)
        EXPECT_LT(apart(curve(t), {50, 0, 0}), 1e-9) << t;
    const TimedCurve still({0, 10}, {{7, 8, 9}, {7, 8, 9}}, true);
    EXPECT_EQ(still(5.0), (Vec3{7, 8, 9}));
}

// Where points lie unevenly a uniform Catmull-Rom curve swings back; the centripetal one
// goes on from point to point.
TEST(TimedCurve, NeverTurnsBackBetweenTwoNearPoints) {
    const TimedCurve curve({0, 1, 2, 3},
                           {{0, 0, 0}, {100, 0, 0}, {101, 0, 0}, {200, 0, 0}}, false);
    for (double t = 0.01; t <= 3.0; t += 0.01)
        EXPECT_GE(curve(t).x, curve(t - 0.01).x - 1e-9) << t;
}

TEST(Shutter, SamplesLieEvenlyAroundTheFrame) {
    CameraOptions camera;
    EXPECT_EQ(shutter_times(camera, 12.0), std::vector<double>{12.0});
    camera.shutter_samples = 4;
    const auto times = shutter_times(camera, 12.0);
    ASSERT_EQ(times.size(), 4u);
    EXPECT_NEAR(std::accumulate(times.begin(), times.end(), 0.0) / 4.0, 12.0, 1e-12);
    EXPECT_NEAR(times[1] - times[0], 0.125, 1e-12);  // half a frame in four
    EXPECT_NEAR(times[3] - times[0], 0.375, 1e-12);
}

class Path : public testing::Test {
  protected:
    Path() {
        land.spacing = 10.0;
        land.heights = Field<float>(64, 64, 100.0f);
        // A ridge from south to north in the middle.
        for (int y = 0; y < 64; ++y)
            for (int x = 30; x < 34; ++x) land.heights(x, y) = 180.0f;
        camera.name = "flight";
        camera.kind = CameraOptions::Kind::kPath;
        camera.keys = {key(0, {50, 100, 100}), key(24, {320, 100, 60}),
                       key(48, {600, 100, 100})};
    }
    static CameraKey key(double frame, std::array<double, 3> eye) {
        return {frame,
                {metres(eye[0]), metres(eye[1]), metres(eye[2])},
                {metres(300.0), metres(500.0), metres(0.0)}};
    }
    Camera at(double frame) const {
        CameraOptions then = camera;
        then.frame = frame;
        return place(then, land, Quality::kDraft);
    }
    std::string refusal() const {
        try {
            place(camera, land, Quality::kDraft);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ExitCode::kBadRequest);
            return e.what();
        }
        return "";
    }
    Terrain land;
    CameraOptions camera;
};

TEST_F(Path, KeysStandOverTheGroundThere) {
    EXPECT_NEAR(at(0.0).eye.z, 200.0, 1e-6);
    EXPECT_NEAR(at(24.0).eye.z, 240.0, 1e-6);
    EXPECT_NEAR(at(24.0).eye.x, 320.0, 1e-6);
    const Camera end = at(1000.0);
    EXPECT_NEAR(end.eye.x, 600.0, 1e-6);
    EXPECT_NEAR(end.target.y, 500.0, 1e-6);
}

// Between two keys it flies in the air, not along the ground.
TEST_F(Path, DoesNotFollowTheGround) {
    land.heights(12, 54) = 130.0f;
    const double before = at(8.0).eye.z;
    land.heights(12, 54) = 100.0f;
    EXPECT_EQ(before, at(8.0).eye.z);
}

TEST_F(Path, ThroughAHillIsRefusedWithTheFrame) {
    camera.keys = {key(0, {50, 100, 20}), key(48, {600, 100, 20})};
    const std::string text = refusal();
    EXPECT_NE(text.find("under the ground or water at frame 2"), std::string::npos)
        << text;
    EXPECT_NE(text.find("raise the eyes of the keys at 0 and 48"), std::string::npos)
        << text;
}

TEST_F(Path, KeysOutOfOrderAreRefused) {
    std::swap(camera.keys[1], camera.keys[2]);
    EXPECT_NE(refusal().find("the key at frame 24 stands after the one at 48"),
              std::string::npos);
    camera.keys[2].frame = 48.0;
    EXPECT_NE(refusal(), "");
    camera.keys.resize(1);
    EXPECT_NE(refusal().find("two keys or more"), std::string::npos);
}

TEST_F(Path, WhereItMeetsItsTargetIsRefused) {
    camera.keys = {key(0, {300, 400, 50}), key(48, {300, 600, 50})};
    for (CameraKey& k : camera.keys) k.target[2] = metres(50.0);
    EXPECT_NE(refusal().find("eye and target are the same point at frame 24"),
              std::string::npos)
        << refusal();
}

}  // namespace
}  // namespace cydonia::render
