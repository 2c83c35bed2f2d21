// The sky against what was published of skies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "field/parallel.h"
#include "field/vec.h"
#include "render/sky/clouds.h"
#include "render/sky/haze.h"
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

TEST(AirLight, NearAirIsBluerThanTheHorizon) {
    const auto blue = [](double distance) {
        const Rgb air =
            air_light(up(40.0), {.turbidity = 1.9}, radians(230.0), 0.5, distance);
        return air[2] / air[0];
    };
    EXPECT_GT(blue(5e3), 1.2 * blue(60e3));
    EXPECT_GT(blue(60e3), blue(1e6));
}

TEST(Haze, VisibilityFollowsTurbidity) {
    const auto seen = [](double turbidity) {
        return visibility({.turbidity = turbidity}, {}, 1e4);
    };
    EXPECT_GT(seen(1.9), 120e3);
    EXPECT_LT(seen(10.0), 30e3);
    EXPECT_EQ(visibility({}, {.visibility = of_width(3.0)}, 1e4), 3e4);
    EXPECT_EQ(visibility({.air = false}, {}, 1e4), 0.0);
}

TEST(Haze, LeavesTwoPercentAtItsDistanceAndLessOnHigherGround) {
    EXPECT_NEAR(through_haze(20e3, 0.0, 0.0, 20e3), 0.02, 1e-3);
    EXPECT_GT(through_haze(20e3, kHazeHeight, 0.0, 20e3), 0.3);
    // A way is its parts.
    const double whole = through_haze(20e3, 500.0, 0.1, 9e3);
    EXPECT_NEAR(through_haze(20e3, 500.0, 0.1, 4e3) * through_haze(20e3, 900.0, 0.1, 5e3),
                whole, 1e-9);
}

// Haze over the sky's image behind it gives the sky, in every direction that haze does
// not hide.
TEST(Haze, LeavesTheSkyAsItIs) {
    const Sun sun = up(12.0);
    const Rgb light = air_light(sun, {}, radians(30.0), 0.8, 30e3);
    const double seen = visibility({}, {}, 1e4), eye = 800.0;
    const Field<Rgb> sky = sky_dome(sun, {}, 1024);
    const Field<Rgb> behind = behind_haze(sky, light, seen, eye);
    ASSERT_EQ(behind.height(), sky.height());
    for (int y = 0; y < 512; ++y) {
        const double elevation = std::numbers::pi / 2.0 * (1.0 - (y + 0.5) / 512);
        if (elevation < radians(3.0)) break;
        const double through = through_haze(seen, eye, std::sin(elevation), 1e9);
        for (int x = 0; x < 2048; x += 64)
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(through * behind(x, y)[c] + (1.0 - through) * light[c],
                            sky(x, y)[c], 0.02 * luminance(sky(x, y)))
                    << degrees(elevation) << " " << x;
    }
}

TEST(Airless, BlackSkyAndWhiteSun) {
    const SkyOptions none{.air = false};
    for (const double elevation : {2.0, 60.0}) {
        const Daylight light = render::daylight(up(elevation), none);
        EXPECT_EQ(light.sun, (Rgb{1.0f, 1.0f, 1.0f}));
        EXPECT_EQ(light.horizon, Rgb{});
        EXPECT_LT(luminance(light.sky), 0.05);  // of other slopes
    }
    for (const Rgb& c : sky_dome(up(20.0), none, 32)) ASSERT_EQ(c, Rgb{});
}

TEST(Dust, ButterscotchSkyAndBluishGlowAroundALowSun) {
    const SkyOptions mars{.turbidity = 8.0, .dust = Rgb{0.97f, 0.88f, 0.68f}};
    const Daylight noon = render::daylight(up(50.0), mars);
    EXPECT_GT(noon.sky[0], 1.1f * noon.sky[1]);
    EXPECT_GT(noon.sky[1], 1.2f * noon.sky[2]);
    const Sun low = up(5.0);
    const auto blue = [&](double off) {
        const Rgb air = air_light(low, mars, low.azimuth + radians(off), 0.05);
        return air[2] / air[0];
    };
    EXPECT_GT(blue(0.0), 1.5 * blue(90.0));
}

// Directions that meet a cloud, and what each sends for what it covers.
struct Covered {
    double through, light;
};
std::vector<Covered> covered(const CloudLayer& clouds, const Sun& sun, double off) {
    std::vector<Covered> found;
    for (int i = 0; i < 400; ++i) {
        const Sun toward{sun.azimuth + radians(off) + 0.001 * (i % 20),
                         sun.elevation + 0.004 * (i / 20)};
        const auto seen =
            clouds.seen(direction_to(toward), {1.0, 1.0, 1.0}, {0.1, 0.1, 0.1});
        if (seen.through < 0.97)
            found.push_back({seen.through, seen.light.x / (1.0 - seen.through)});
    }
    return found;
}
double mean_light(const std::vector<Covered>& all, double from, double to) {
    double sum = 0.0, count = 0.0;
    for (const Covered& c : all)
        if (c.through >= from && c.through < to) sum += c.light, count += 1.0;
    return count > 0.0 ? sum / count : -1.0;
}

TEST(Clouds, ShineTowardTheSun) {
    const Sun sun = up(30.0);
    const CloudLayer ice(Clouds::kCirrus, sun);
    EXPECT_GT(mean_light(covered(ice, sun, 10.0), 0.0, 1.0),
              2.0 * mean_light(covered(ice, sun, 120.0), 0.0, 1.0));
}

// Seen from below with the sun behind them.
TEST(Clouds, ThickerIsDarkerBelow) {
    const Sun sun = up(60.0);
    const CloudLayer heaps(Clouds::kBroken, sun);
    std::vector<Covered> all;
    for (double off = 0.0; off < 360.0; off += 15.0)
        for (const Covered& c : covered(heaps, sun, off)) all.push_back(c);
    const double thick = mean_light(all, 0.0, 0.02), thin = mean_light(all, 0.5, 0.97);
    ASSERT_GT(thick, 0.0);
    EXPECT_LT(thick, 0.7 * thin);
}

// Correlation of two maps, one of them `cells` further east.
double alike(const Field<float>& a, const Field<float>& b, int cells) {
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x + cells < a.width(); ++x) {
            const double u = 1.0 - a(x + cells, y), v = 1.0 - b(x, y);
            ab += u * v, aa += u * u, bb += v * v;
        }
    return ab / std::sqrt(aa * bb);
}

// With the sun in the east at 45 degrees, a shadow lies as far west of its cloud as the
// cloud is high.
TEST(Clouds, ShadowFallsAgainstTheSun) {
    constexpr int kCells = 128;
    const auto shade = [](double elevation) {
        return cloud_shadows({radians(90.0), radians(elevation)}, {}, 200.0 * kCells,
                             kCells);
    };
    const Field<float> overhead = shade(89.9), morning = shade(45.0);
    const auto [dark, bright] = std::ranges::minmax(overhead);
    EXPECT_LT(dark, 0.3f);
    EXPECT_EQ(bright, 1.0f);
    EXPECT_GT(alike(overhead, morning, 11), 0.8);  // 2.2 km
    EXPECT_LT(alike(overhead, morning, 0), 0.8 * alike(overhead, morning, 11));
}

// A sheet aloft holds the shadow that the sun draws on from there.
TEST(Clouds, SheetAloftThrowsTheSameShadow) {
    const Sun sun{radians(90.0), radians(45.0)};
    const Field<float> ground = cloud_shadows(sun, {}, 12.8e3, 64);
    const Field<float> aloft = cloud_shadows(sun, {1e3, 0.0, 1e3}, 12.8e3, 64);
    for (std::size_t i = 0; i < ground.size(); ++i)
        ASSERT_NEAR(ground.begin()[i], aloft.begin()[i], 1e-3f);
}

}  // namespace
}  // namespace cydonia::render
