// What a day over the land is made of, without making any land.
#include "app/sequence/day.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field/error.h"
#include "field/sun_path.h"
#include "render/cameras/cameras.h"

namespace cydonia {
namespace {

using config::FramesSpec;

ShadowImage image(double azimuth, double elevation) {
    ShadowImage image;
    image.name = "text";
    image.sun = {radians(azimuth), radians(elevation)};
    return image;
}

render::CameraOptions camera() { return render::default_cameras().front(); }

FramesSpec at_lucerne(const Date& date) {
    FramesSpec frames;
    frames.place = GeographicPosition{radians(47.05), radians(8.3)};
    frames.date = date;
    frames.time_zone = 2.0;
    return frames;
}

const Shot& key_of(const Day& day) {
    return day.sequence.shots.at(static_cast<std::size_t>(day.sequence.still));
}

bool says(const Day& day, const std::string& words) {
    return std::ranges::any_of(day.news, [&](const std::string& sentence) {
        return sentence.find(words) != sentence.npos;
    });
}

TEST(Day, AnArcLeadsThroughEveryImagesSun) {
    for (const double azimuth : {0.0, 35.0, 90.0, 180.0, 215.0, 300.0})
        for (const double elevation : {3.0, 25.0, 60.0}) {
            const ShadowImage shown = image(azimuth, elevation);
            const Day day = day_over({}, camera(), {shown});
            ASSERT_EQ(day.sequence.shots.size(), 48u);
            EXPECT_EQ(key_of(day).camera.sun, shown.sun) << azimuth << ' ' << elevation;
            EXPECT_TRUE(day.appears);
            const Sun first = *day.sequence.shots.front().camera.sun;
            const Sun last = *day.sequence.shots.back().camera.sun;
            EXPECT_GT(std::sin(first.azimuth), 0.0) << "begins in the east";
            EXPECT_LT(std::sin(last.azimuth), 0.0) << "ends in the west";
            EXPECT_NEAR(first.elevation,
                        std::min(radians(2.0), 0.5 * shown.sun.elevation), 1e-6);
            for (const Shot& shot : day.sequence.shots)
                EXPECT_GT(shot.camera.sun->elevation, 0.0);
        }
}

TEST(Day, SunMovesOnFromFrameToFrame) {
    for (const auto pace : {FramesSpec::Pace::kLingering, FramesSpec::Pace::kEven}) {
        FramesSpec frames;
        frames.pace = pace;
        const Day day = day_over(frames, camera(), {image(215, 25)});
        const auto& shots = day.sequence.shots;
        for (std::size_t i = 1; i < shots.size(); ++i)
            EXPECT_GT(angle_between(*shots[i].camera.sun, *shots[i - 1].camera.sun),
                      radians(0.05));
    }
}

TEST(Day, LingersWhereTheImageAppears) {
    const auto near_image = [](FramesSpec::Pace pace) {
        FramesSpec frames;
        frames.pace = pace;
        const ShadowImage shown = image(215, 25);
        const Day day = day_over(frames, camera(), {shown});
        return std::ranges::count_if(day.sequence.shots, [&](const Shot& shot) {
            return angle_between(*shot.camera.sun, shown.sun) < radians(5.0);
        });
    };
    EXPECT_GE(near_image(FramesSpec::Pace::kLingering), 7);
    EXPECT_LE(near_image(FramesSpec::Pace::kEven), 4);
}

TEST(Day, FewFrames) {
    for (const int count : {1, 2, 3, 4}) {
        FramesSpec frames;
        frames.count = count;
        const Day day = day_over(frames, camera(), {image(215, 25)});
        EXPECT_EQ(day.sequence.shots.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(key_of(day).camera.sun, image(215, 25).sun);
    }
}

TEST(Day, FramesAreNumberedShotsOfTheCamera) {
    const Day day = day_over({}, camera(), {image(215, 25)});
    EXPECT_EQ(day.sequence.shots.front().camera.name, "day-0001");
    EXPECT_EQ(day.sequence.shots.back().camera.name, "day-0048");
    EXPECT_EQ(day.sequence.camera, "overhead");
    EXPECT_EQ(day.sequence.shots[7].camera.size, camera().size);
}

TEST(Day, TellsTheHourAtAPlace) {
    const FramesSpec frames = at_lucerne({2026, 6, 21});
    const double hour = 17.7;
    ShadowImage shown = image(0, 0);
    shown.sun = sun_path(*frames.place, *frames.date, 2.0)(hour);
    const Day day = day_over(frames, camera(), {shown});
    EXPECT_TRUE(day.appears);
    EXPECT_TRUE(says(day, "on 21 June 2026 at 17:42 (UTC+2), the sun 0.0 degrees"))
        << day.news.back();
    EXPECT_EQ(key_of(day).when, "17:42 (UTC+2)");
    // The sun rose there at 5:31 and set at 21:26 by that clock; filmed from 2 degrees.
    EXPECT_TRUE(says(day, "from 05:50 to 21:08 (UTC+2)")) << day.news.front();
}

TEST(Day, TellsByHowMuchTheSunMisses) {
    const FramesSpec frames = at_lucerne({2026, 1, 15});
    ShadowImage shown = image(0, 0);
    shown.sun = sun_path(*frames.place, {2026, 4, 12}, 2.0)(16.5);
    const Day day = day_over(frames, camera(), {shown});
    EXPECT_FALSE(day.appears);
    EXPECT_TRUE(says(day, "does not appear on 15 January 2026")) << day.news.back();
    EXPECT_TRUE(says(day, "the nearest day on which it appears is 10 April 2026"))
        << day.news.back();
    EXPECT_EQ(day.sequence.hold, 0.0);
    // The sun that it offers instead does it.
    const Approach found =
        nearest(sun_path(*frames.place, *frames.date, 2.0), shown.sun, Hours{6.0, 20.0});
    ShadowImage moved = shown;
    moved.sun = found.sun;
    EXPECT_TRUE(day_over(frames, camera(), {moved}).appears);
}

TEST(Day, NeverInTheNorth) {
    const Day day = day_over(at_lucerne({2026, 6, 21}), camera(), {image(0, 40)});
    EXPECT_FALSE(day.appears);
    EXPECT_TRUE(says(day, "no day of 2026 brings it nearer")) << day.news.back();
}

TEST(Day, TimeZoneIsTheLongitudesUnlessGiven) {
    FramesSpec frames = at_lucerne({2026, 6, 21});
    frames.time_zone.reset();
    EXPECT_TRUE(says(day_over(frames, camera(), {image(180, 66)}), "(UTC+1)"));
    frames.time_zone = -3.5;
    EXPECT_TRUE(says(day_over(frames, camera(), {image(180, 66)}), "(UTC-3:30)"));
}

TEST(Day, OfEverySunAfterTheFirst) {
    const Day day = day_over({}, camera(), {image(215, 25), image(90, 25)});
    EXPECT_EQ(day.news.size(), 3u);
    EXPECT_TRUE(says(day, "from the arc of the first")) << day.news.back();
}

TEST(Day, WithoutAnImageNoonIsTheKey) {
    const Day day = day_over(at_lucerne({2026, 6, 21}), camera(), {});
    EXPECT_NEAR(degrees(key_of(day).camera.sun->azimuth), 180.0, 1.0);
    EXPECT_EQ(day.sequence.exposure, 0.0);
}

TEST(Day, FilmsWithTheCameraThatIsAskedFor) {
    FramesSpec frames;
    auto cameras = render::default_cameras();
    std::ranges::reverse(cameras);
    EXPECT_EQ(filming_camera(frames, cameras).name, "overhead");
    frames.camera = "oblique";
    EXPECT_EQ(filming_camera(frames, cameras).name, "oblique");
    EXPECT_EQ(filming_camera({}, {cameras.front()}).name, "oblique");
}

std::string refusal(const config::SceneSpec& scene) {
    try {
        check_day(scene);
        check_names(scene, "day", 48);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadRequest);
        return error.what();
    }
    return "";
}

TEST(Day, IsRefusedWithoutAnythingToFilm) {
    config::SceneSpec scene;
    EXPECT_NE(refusal(scene).find("no shadow image"), std::string::npos);
    scene.frames = at_lucerne({2026, 6, 21});
    EXPECT_EQ(refusal(scene), "");
    scene.frames.place->latitude = radians(-80.0);
    EXPECT_NE(refusal(scene).find("stays below 2 degrees on 21 June 2026"),
              std::string::npos);
    scene.frames = at_lucerne({2026, 6, 21});
    scene.render.cameras = {camera()};
    scene.render.cameras[0].name = "day-0048";
    EXPECT_NE(refusal(scene).find("rename it"), std::string::npos);
    scene.render.cameras[0].name = "day-0049";
    EXPECT_EQ(refusal(scene), "");
}

}  // namespace
}  // namespace cydonia
