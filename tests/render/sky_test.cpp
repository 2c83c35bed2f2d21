// The sky against what was published of skies.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "field/parallel.h"
#include "field/vec.h"
#include "render/sky/sky.h"

namespace cydonia::render {
namespace {

constexpr double kKilolux = 128.0;  // of the sun outside the air (render/sky/sky.h)

Sun up(double elevation) { return {radians(140.0), radians(elevation)}; }
double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

// IES RP-21, "Calculation of Daylight Availability" (1984): a clear day at the sea.
double ies_sun(double sine) { return 127.5 * std::exp(-0.21 / sine); }
double ies_sky(double sine) { return 0.8 + 15.5 * std::sqrt(sine); }
double ies_overcast(double sine) { return 0.3 + 21.0 * sine; }

TEST(Sky, LightsAsAClearDayDoes) {
    for (const double elevation : {10.0, 30.0, 60.0}) {
        const Daylight light = render::daylight(up(elevation), {});
        const double sine = std::sin(radians(elevation));
        EXPECT_NEAR(kKilolux * luminance(light.sun) / ies_sun(sine), 1.0, 0.08);
        EXPECT_NEAR(kKilolux * luminance(light.sky) / ies_sky(sine), 1.0, 0.15);
        EXPECT_GT(light.sky[2], 1.4f * light.sky[0]);
    }
}

TEST(Sky, LightsAsAnOvercastDayDoes) {
    for (const double elevation : {10.0, 30.0, 60.0}) {
        const Daylight light =
            render::daylight(up(elevation), {.clouds = Clouds::kOvercast});
        EXPECT_EQ(light.sun, Rgb{});
        EXPECT_NEAR(
            kKilolux * luminance(light.sky) / ies_overcast(std::sin(radians(elevation))),
            1.0, 0.35);
        EXPECT_LT(light.sky[2], 1.1f * light.sky[0]);
    }
}

TEST(Sky, SunIsWeakerAndRedderTheLowerItStands) {
    Rgb higher = render::daylight(up(89.0), {}).sun;
    for (double elevation = 80.0; elevation > -2.0; elevation -= 2.0) {
        const Rgb sun = render::daylight(up(elevation), {}).sun;
        if (luminance(sun) == 0.0) {
            EXPECT_LT(elevation, 0.0);
            break;
        }
        EXPECT_LT(luminance(sun), luminance(higher));
        EXPECT_LT(sun[1] / sun[0], higher[1] / higher[0]);
        EXPECT_LE(sun[2] * higher[1], sun[1] * higher[2]);
        higher = sun;
    }
}

// Civil twilight ends at 3.4 lx.
TEST(Sky, TwilightFadesWithoutSun) {
    double before = luminance(render::daylight(up(0.0), {}).sky);
    for (const double elevation : {-1.0, -2.0, -3.0, -4.0, -5.0, -6.0}) {
        const Daylight light = render::daylight(up(elevation), {});
        EXPECT_LT(luminance(light.sky), before);
        before = luminance(light.sky);
        EXPECT_GT(before, 0.0);
        if (elevation < -1.5) {
            EXPECT_EQ(light.sun, Rgb{});
        }
    }
    EXPECT_NEAR(std::log10(1e3 * kKilolux * before), std::log10(3.4), 0.5);
}

TEST(Sky, MoonIsAFaintBlueSun) {
    const Daylight day = render::daylight(up(40.0), {});
    const Daylight full = render::daylight(up(40.0), {.moon = 1.0});
    const Daylight half = render::daylight(up(40.0), {.moon = 0.5});
    EXPECT_GT(full.sun[2] / full.sun[0], 1.5f * day.sun[2] / day.sun[0]);
    EXPECT_NEAR(luminance(full.sun) / luminance(day.sun), 1.0, 0.1);  // the night's unit
    EXPECT_NEAR(luminance(half.sun) / luminance(full.sun), 0.09, 0.01);  // Allen 1976
    // Stars and airglow are left where the moon is thin.
    EXPECT_GT(luminance(half.sky), 0.095 * luminance(full.sky));
}

TEST(Sky, SnowAllAroundLightsTheAir) {
    const auto sky = [](double albedo) {
        return luminance(render::daylight(up(30.0), {.ground_albedo = albedo}).sky);
    };
    EXPECT_GT(sky(0.8), 1.05 * sky(0.2));
    EXPECT_LT(sky(0.0), sky(0.2));
}

TEST(Sky, MeanIsTheDomes) {
    for (const Clouds clouds : {Clouds::kNone, Clouds::kOvercast}) {
        const SkyOptions options{.clouds = clouds};
        const Field<Rgb> dome = sky_dome(up(35.0), options, 128);
        double sum = 0.0, weights = 0.0;
        for (int y = 0; y < 64; ++y) {
            const double e = std::numbers::pi / 2.0 * (1.0 - (y + 0.5) / 64);
            for (int x = 0; x < 256; ++x) {
                sum += std::sin(e) * std::cos(e) * luminance(dome(x, y));
                weights += std::sin(e) * std::cos(e);
            }
        }
        EXPECT_NEAR(sum / weights / luminance(render::daylight(up(35.0), options).sky),
                    1.0, 0.03);
    }
}

TEST(AirLight, IsBrighterAndWarmerTowardALowSun) {
    const Sun low = up(6.0);
    const Rgb toward = air_light(low, {}, low.azimuth, radians(40.0));
    const Rgb away = air_light(low, {}, low.azimuth + radians(180.0), radians(40.0));
    EXPECT_GT(luminance(toward), 1.5 * luminance(away));
    EXPECT_GT(toward[0] / toward[2], away[0] / away[2]);
}

}  // namespace
}  // namespace cydonia::render
