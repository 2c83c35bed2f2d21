// What turntables and films are made of, without making any land.
#include "app/sequence/turntable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/sequence/timeline.h"
#include "field/error.h"
#include "render/cameras/cameras.h"

namespace cydonia {
namespace {

using config::FramesSpec;
using render::CameraOptions;
using Kind = CameraOptions::Kind;

CameraOptions camera(const std::string& name, Kind kind) {
    CameraOptions camera;
    camera.name = name;
    camera.kind = kind;
    return camera;
}

FramesSpec frames_of(int count, const std::string& camera = "") {
    FramesSpec frames;
    frames.count = count;
    frames.camera = camera;
    return frames;
}

// Ground that is as high all around its middle.
Terrain cone() {
    Terrain land;
    land.spacing = 10.0;
    land.heights = Field<float>(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            land.heights(x, y) =
                static_cast<float>(200.0 - 5.0 * std::hypot(x - 31.5, y - 31.5));
    return land;
}

double azimuth_of(const Vec3& from, const Vec3& to) {
    return std::atan2(to.x - from.x, to.y - from.y);
}

TEST(Turntable, GoesOnceAroundAtOneHeightAndDistance) {
    const Terrain land = cone();
    for (const Kind kind : {Kind::kOrbit, Kind::kOblique}) {
        const auto frames =
            turntable(frames_of(12, "view"), {camera("view", kind)}).frames;
        ASSERT_EQ(frames.size(), 12u);
        const auto eye = [&](const CameraOptions& options) {
            return render::place(options, land, render::Quality::kDraft).eye;
        };
        const Vec3 middle{320.0, 320.0, 0.0}, first = eye(frames[0].camera);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const Vec3 now = eye(frames[i].camera), next = eye(*frames[i].next);
            EXPECT_NEAR(now.z, first.z, 1e-6);
            EXPECT_NEAR(std::hypot(now.x - 320.0, now.y - 320.0),
                        std::hypot(first.x - 320.0, first.y - 320.0), 1e-6);
            // Clockwise from above, and the last frame comes before the first.
            const double step = azimuth_of(middle, next) - azimuth_of(middle, now);
            EXPECT_NEAR(std::remainder(step, 2.0 * std::numbers::pi),
                        std::numbers::pi / 6.0, 1e-6);
            const Vec3 follower = eye(frames[(i + 1) % 12].camera);
            EXPECT_NEAR(length(follower - next), 0.0, 1e-6);
        }
    }
}

TEST(Turntable, TurnsAroundWhatTheCameraLooksAt) {
    CameraOptions options = camera("peak", Kind::kLookAt);
    options.eye = {metres(320.0), metres(20.0), metres(60.0)};
    options.target = {metres(320.0), metres(220.0), metres(10.0)};
    options.turn = radians(90.0);
    const Camera c = render::place(options, cone(), render::Quality::kDraft);
    EXPECT_NEAR(c.target.x, 320.0, 1e-6);
    EXPECT_NEAR(c.target.y, 220.0, 1e-6);
    EXPECT_NEAR(c.eye.x, 120.0, 1e-6) << "from the south to the west";
    EXPECT_NEAR(c.eye.y, 220.0, 1e-6);
}

TEST(Turntable, ChoosesACameraThatCanTurn) {
    const std::vector<CameraOptions> cameras{
        camera("map", Kind::kOverhead), camera("hills", Kind::kOblique),
        camera("round", Kind::kOrbit), camera("walker", Kind::kStand)};
    EXPECT_EQ(turntable(frames_of(2), cameras).camera, "round");
    EXPECT_EQ(turntable(frames_of(2, "hills"), cameras).camera, "hills");
    EXPECT_EQ(turntable(frames_of(2, "map"), cameras).camera, "round");
    const Sequence own = turntable(frames_of(2), {cameras[0]});
    EXPECT_EQ(own.frames[0].camera.kind, Kind::kOrbit);
    EXPECT_EQ(own.frames[0].camera.name, "turntable-0001");
}

TEST(Turntable, ItsShutterIsOpenAroundEachFrame) {
    CameraOptions options = camera("round", Kind::kOrbit);
    options.shutter_samples = 3;
    const auto frames = turntable(frames_of(36), {options}).frames;
    ASSERT_EQ(frames[9].moments.size(), 3u);
    EXPECT_EQ(frames[9].moments[1].turn, frames[9].camera.turn);
    EXPECT_NEAR(frames[9].moments[2].turn - frames[9].moments[0].turn,
                radians(10.0) * 0.5 * 2.0 / 3.0, 1e-9);
    options.shutter_samples = 1;
    EXPECT_TRUE(turntable(frames_of(36), {options}).frames[9].moments.empty());
}

TEST(Turntable, EveryTenthFrameExposesAll) {
    EXPECT_EQ(turntable(frames_of(21), {}).exposed_by,
              (std::vector<std::size_t>{0, 10, 20}));
    EXPECT_EQ(every_tenth(1), std::vector<std::size_t>{0});
}

CameraOptions flight(double last) {
    CameraOptions options = camera("flight", Kind::kPath);
    options.keys.resize(2);
    options.keys[1].frame = last;
    return options;
}

// A scene whose sun climbs a degree a frame.
Clock climbing(double last_key) {
    const auto at = [](double frame) {
        config::SceneSpec then;
        then.render.sun = Sun{0.0, radians(10.0 + frame)};
        then.render.cameras = {camera("round", Kind::kOrbit)};
        return then;
    };
    return {at, true, last_key};
}

TEST(Timeline, IsAsLongAsThePathOrTheKeys) {
    config::SceneSpec scene;
    const auto of = [&](const Clock& clock, const std::vector<CameraOptions>& cameras) {
        return timeline(clock, scene, cameras).sequence.frames.size();
    };
    const auto still = [&](double) { return scene; };
    EXPECT_EQ(of({still}, {camera("map", Kind::kOverhead), flight(95.0)}), 96u);
    const Clock clock = climbing(24.0);
    scene = clock.at(0.0);
    EXPECT_EQ(of(clock, scene.render.cameras), 25u);
    scene.frames.count = 7;
    EXPECT_EQ(of(clock, scene.render.cameras), 7u);
}

TEST(Timeline, SaysThatKeysAreBeyondItsEnd) {
    config::SceneSpec scene;
    const auto still = [&](double) { return scene; };
    EXPECT_TRUE(timeline({still}, scene, {flight(95.0)}).messages.empty());
    scene.frames.count = 48;
    const auto messages = timeline({still}, scene, {flight(95.0)}).messages;
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(
        messages[0],
        "the keys go on to frame 95, the film ends at 47: frames.count = 96 has all");
}

TEST(Timeline, EveryShotHasItsOwnScene) {
    const Clock clock = climbing(5.0);
    const config::SceneSpec scene = clock.at(0.0);
    const auto frames = timeline(clock, scene, scene.render.cameras).sequence.frames;
    ASSERT_EQ(frames.size(), 6u);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        ASSERT_TRUE(frames[i].scene);
        EXPECT_NEAR(frames[i].scene->render.sun->elevation,
                    radians(10.0 + static_cast<double>(i)), 1e-12);
        EXPECT_EQ(frames[i].camera.frame, static_cast<double>(i));
        EXPECT_EQ(frames[i].next->frame, static_cast<double>(i) + 1.0);
    }
    config::SceneSpec constant;
    const auto flown =
        timeline({[&](double) { return constant; }}, constant, {flight(5.0)});
    EXPECT_FALSE(flown.sequence.frames[0].scene);
}

TEST(Timeline, WithoutAnythingThatMovesIsRefused) {
    config::SceneSpec scene;
    try {
        timeline({[&](double) { return scene; }}, scene,
                 {camera("map", Kind::kOverhead)});
        FAIL() << "nothing moves";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadRequest);
        EXPECT_NE(std::string(error.what()).find("nothing to film"), std::string::npos);
    }
}

}  // namespace
}  // namespace cydonia
