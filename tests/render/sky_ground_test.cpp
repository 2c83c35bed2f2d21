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

Rgb mean(const Field<Rgb>& image) {
    Rgb sum{};
    for (const Rgb& c : image)
        for (int i = 0; i < 3; ++i) sum[i] += c[i] / static_cast<float>(image.size());
    return sum;
}

}  // namespace

TEST(Sky, SunReddensAsItSinks) {
    const Rgb high = render::daylight(sun_at(90, 60), {}).sun,
              low = render::daylight(sun_at(90, 5), {}).sun;
    EXPECT_GT(luminance(high), luminance(low));
    EXPECT_GT(low[0] / low[2], 3.0f * high[0] / high[2]);
}

TEST(Sky, IsBlueAboveAndNearWhatWasMeasured) {
    // A clear day at 25 degrees, altitude 1500 m: sun .875 .743 .583, sky .026 .047 .096.
    const Daylight light = render::daylight(sun_at(180, 25), {});
    EXPECT_NEAR(light.sun[0], 0.875, 0.05);
    EXPECT_NEAR(light.sun[2], 0.583, 0.08);
    EXPECT_NEAR(light.sky[1], 0.047, 0.01);
    EXPECT_GT(light.sky[2], 2.0f * light.sky[0]);
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

TEST(Ground, SteepLandIsRockAndFlatLandIsNot) {
    const Rgb flat = mean(ground_albedo(plane(0.05), {}, 2));
    const Rgb steep = mean(ground_albedo(plane(1.5), {}, 2));
    EXPECT_LT(flat[2] / flat[0], 0.62f);    // earth and grass: little blue
    EXPECT_GT(steep[2] / steep[0], 0.62f);  // grey
}

TEST(Ground, SnowLiesAboveItsLineAndNotOnCliffs) {
    const GroundOptions snowy{.snow_line = metres(-1000.0)};
    EXPECT_GT(luminance(mean(ground_albedo(plane(0.2), snowy, 1))), 0.7f);
    EXPECT_LT(luminance(mean(ground_albedo(plane(1.8), snowy, 1))), 0.3f);
}

// Under water: neither snow nor grass, and little red where it is deep.
TEST(Ground, UnderWaterIsSandThatFadesWithDepth) {
    const GroundOptions snowy{.snow_line = metres(-1000.0)};
    Terrain terrain = plane(0.1);  // from 63 m in the north to 0
    terrain.water = Field<float>(64, 64, kDry);
    for (int y = 32; y < 64; ++y)
        for (int x = 0; x < 64; ++x) terrain.water(x, y) = 32.0f;
    const Field<Rgb> ground = ground_albedo(terrain, snowy, 1);
    for (int x = 0; x < 64; ++x) {
        EXPECT_GT(luminance(ground(x, 10)), 0.7f);
        EXPECT_GT(luminance(ground(x, 32)), 0.14f);
        EXPECT_LT(luminance(ground(x, 33)), 0.3f);
        EXPECT_GT(ground(x, 33)[0], ground(x, 33)[2]);         // sand
        EXPECT_LT(ground(x, 45)[0], 0.2f * ground(x, 45)[1]);  // 14 m down
        EXPECT_LT(luminance(ground(x, 60)), luminance(ground(x, 45)));
    }
}

TEST(Ground, NoSnowLiesUnderWater) {
    Terrain terrain = plane(0.7);  // steep enough for rock to show through sand
    terrain.water = terrain.heights;
    for (float& level : terrain.water) level += 0.5f;
    for (const Rgb& c : ground_albedo(terrain, {.snow_line = metres(-1000.0)}, 1))
        EXPECT_LT(luminance(c), 0.3f);
}

TEST(Ground, AlbedoIsPhysical) {
    for (const Rgb& c : ground_albedo(plane(0.7), {.snow_line = metres(200.0)}, 2))
        for (float v : c) ASSERT_TRUE(v > 0.01f && v < 0.95f);
}

TEST(SkyVisibility, IsOneOnFlatLandAndHalfAtAWall) {
    Field<float> heights(81, 81);
    EXPECT_FLOAT_EQ(sky_visibility(heights, 1.0)(40, 40), 1.0f);
    for (int y = 0; y < 81; ++y)
        for (int x = 41; x < 81; ++x) heights(x, y) = 1e6f;
    EXPECT_NEAR(sky_visibility(heights, 1.0)(40, 40), 0.5, 0.05);
}
