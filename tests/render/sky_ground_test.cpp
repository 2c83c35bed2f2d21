#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/ground/ground.h"
#include "render/sky/sky.h"

using namespace cydonia;
using namespace cydonia::render;

namespace {

Sun sun_at(double azimuth, double elevation) {
    return {radians(azimuth), radians(elevation)};
}

float luminance(const Rgb& c) { return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]; }

}  // namespace

TEST(Sky, SunReddensAsItSinks) {
    const Rgb high = render::daylight(sun_at(90, 60), {}).sun,
              low = render::daylight(sun_at(90, 5), {}).sun;
    EXPECT_GT(luminance(high), luminance(low));
    EXPECT_GT(low[0] / low[2], 3.0f * high[0] / high[2]);
}

TEST(Sky, HazeGreysTheSky) {
    const Rgb clear = render::daylight(sun_at(180, 30), {.turbidity = 1.9}).sky;
    const Rgb hazy = render::daylight(sun_at(180, 30), {.turbidity = 8.0}).sky;
    EXPECT_LT(hazy[2] / hazy[0], clear[2] / clear[0]);
}

TEST(SkyDome, IsBrightestTowardTheSun) {
    for (double azimuth : {20.0, 110.0, 250.0}) {
        const Field<Rgb> dome = sky_dome(sun_at(azimuth, 20), {}, 64);
        int brightest = 0;
        const int row = 25;  // about 20 degrees up
        for (int x = 0; x < dome.width(); ++x)
            if (luminance(dome(x, row)) > luminance(dome(brightest, row))) brightest = x;
        // Columns run from east to north (render/sky/sky.h).
        const double angle = 360.0 * (brightest + 0.5) / dome.width();
        EXPECT_NEAR(std::remainder(90.0 - azimuth - angle, 360.0), 0.0, 3.0);
    }
}

TEST(SkyDome, HasNoStepAtTheHorizonAndNoNaN) {
    const Field<Rgb> dome = sky_dome(sun_at(75, 3), {}, 64);
    for (const Rgb& c : dome)
        for (float v : c) ASSERT_TRUE(std::isfinite(v) && v >= 0.0f);
    for (int x = 0; x < dome.width(); ++x) EXPECT_EQ(dome(x, 31), dome(x, 32));
}

TEST(SkyVisibility, IsOneOnFlatLandAndHalfAtAWall) {
    Field<float> heights(81, 81);
    EXPECT_FLOAT_EQ(sky_visibility(heights, 1.0)(40, 40), 1.0f);
    for (int y = 0; y < 81; ++y)
        for (int x = 41; x < 81; ++x) heights(x, y) = 1e6f;
    EXPECT_NEAR(sky_visibility(heights, 1.0)(40, 40), 0.5, 0.05);
}
