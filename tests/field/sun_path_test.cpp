#include "field/sun_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cydonia {
namespace {

constexpr double kNear = 0.05;  // degrees

GeographicPosition place(double latitude, double longitude) {
    return {radians(latitude), radians(longitude)};
}

double noon_elevation(const GeographicPosition& at, const Date& date) {
    const SunPath path = sun_path(at, date, 0.0);
    return degrees(path(noon_of(path)).elevation);
}

// NOAA_Solar_Calculations_day, the sheet as it is downloaded: 40 N, 105 W, 21 June 2010,
// 00:06 at UTC-7.
TEST(SunPath, NoaasOwnSheet) {
    const Date date{2010, 6, 21};
    const SolarTime time = solar_time(date, 7.1);
    EXPECT_NEAR(degrees(time.declination), 23.4383706192869, 1e-6);
    EXPECT_NEAR(time.equation, -1.71536757846953, 1e-6);
    const Sun sun = sun_at(place(40, -105), date, 7.1, false);
    EXPECT_NEAR(degrees(sun.elevation), -26.5537621191813, 1e-6);
    EXPECT_NEAR(degrees(sun.azimuth), 1.09867118388445, 1e-6);
    EXPECT_NEAR(degrees(refraction(sun.elevation)), 0.0115456865919242, 1e-6);
}

// Reda and Andreas, Solar Position Algorithm, NREL/TP-560-34302 (2008), table A5.1: a
// far finer method.
TEST(SunPath, TheExampleOfNrel) {
    const Date date{2003, 10, 17};
    const double hour = 12.0 + 30.5 / 60.0 + 7.0;
    EXPECT_NEAR(degrees(solar_time(date, hour).declination), -9.31434, 0.01);
    EXPECT_NEAR(solar_time(date, hour).equation, 14.641503, 0.05);
    const GeographicPosition golden = place(39.742476, -105.1786);
    const Sun without_air = sun_at(golden, date, hour, false);
    EXPECT_NEAR(degrees(without_air.elevation), 39.872046, 0.01);
    EXPECT_NEAR(degrees(without_air.azimuth), 194.340241, 0.01);
    EXPECT_NEAR(degrees(sun_at(golden, date, hour).elevation), 90.0 - 50.11162, 0.01);
}

// The same report for 17 October in universal time: by the local clock, sunrise is at
// 06:12:43 on that day and sunset at 17:20:19 on the day before. The sun's centre is then
// 0.8333 degrees below the horizon.
TEST(SunPath, SunriseAndSunset) {
    const auto day_of = [](const Date& date) {
        const GeographicPosition golden = place(39.742476, -105.1786);
        const auto path = [=](double hour) {
            return sun_at(golden, date, hour + 7.0, false);
        };
        return hours_above(path, radians(-0.8333)).value();
    };
    constexpr double kHalfMinute = 0.5 / 60.0;
    EXPECT_NEAR(day_of({2003, 10, 17}).from, 6.0 + 12.0 / 60.0 + 43.0 / 3600.0,
                kHalfMinute);
    EXPECT_NEAR(day_of({2003, 10, 16}).to, 17.0 + 20.0 / 60.0 + 19.0 / 3600.0,
                kHalfMinute);
}

// Meeus 1998, examples 25.a and 28.a: 13 October 1992, 0 h.
TEST(SunPath, MeeussExamples) {
    const SolarTime time = solar_time({1992, 10, 13}, 0.0);
    EXPECT_NEAR(degrees(time.declination), -7.78507, 0.001);
    EXPECT_NEAR(time.equation, 13.0 + 42.6 / 60.0, 0.02);
}

TEST(SunPath, NoonOfTheSolstices) {
    for (const double latitude : {-60.0, -23.4, 0.0, 40.0, 51.5, 66.0}) {
        const double june = 90.0 - std::abs(latitude - 23.437);
        const double december = 90.0 - std::abs(latitude + 23.437);
        const auto lifted = [](double h) { return h + degrees(refraction(radians(h))); };
        EXPECT_NEAR(noon_elevation(place(latitude, 0), {2026, 6, 21}), lifted(june),
                    kNear);
        EXPECT_NEAR(noon_elevation(place(latitude, 0), {2026, 12, 21}), lifted(december),
                    kNear);
    }
}

TEST(SunPath, RisesInTheEastAtTheEquinox) {
    for (const double latitude : {-35.0, 0.0, 52.0}) {
        const SunPath path = sun_path(place(latitude, 15.0), {2026, 3, 20}, 1.0);
        const auto day = hours_above(path, 0.0);
        ASSERT_TRUE(day);
        EXPECT_NEAR(degrees(path(day->from).azimuth), 90.0, 1.0);
        EXPECT_NEAR(degrees(path(day->to).azimuth), 270.0, 1.0);
        EXPECT_NEAR(day->to - day->from, 12.1, 0.1);
    }
}

TEST(SunPath, TurnsWithTheClockInTheNorthAndAgainstItInTheSouth) {
    EXPECT_LT(sun_over(radians(45.0), 0.0, radians(-30.0)).azimuth, radians(180.0));
    EXPECT_GT(sun_over(radians(45.0), 0.0, radians(30.0)).azimuth, radians(180.0));
    const double morning = sun_over(radians(-45.0), 0.0, radians(-30.0)).azimuth;
    const double evening = sun_over(radians(-45.0), 0.0, radians(30.0)).azimuth;
    EXPECT_LT(morning, radians(90.0));
    EXPECT_GT(evening, radians(270.0));
}

TEST(SunPath, PolarDayAndNight) {
    const GeographicPosition cape = place(71.17, 25.78);
    const auto day = hours_above(sun_path(cape, {2026, 6, 21}, 2.0), 0.0);
    ASSERT_TRUE(day);
    EXPECT_DOUBLE_EQ(day->to - day->from, 24.0);
    EXPECT_FALSE(hours_above(sun_path(cape, {2026, 12, 21}, 1.0), 0.0));
    EXPECT_EQ(approaches_in(2026, place(90, 0), 0.0, {1.0, 0.3}).size(), 190u)
        << "half a year of day at the pole, and what refraction adds";
}

TEST(SunPath, NoonWhereTheClockIsFarFromTheSun) {
    for (const double zone : {-12.0, 0.0, 12.0}) {
        const SunPath path = sun_path(place(-18.0, 179.0), {2026, 6, 21}, zone);
        const auto day = hours_above(path, 0.0);
        ASSERT_TRUE(day);
        EXPECT_NEAR(day->to - day->from, 11.1, 0.1) << zone;
        EXPECT_NEAR(degrees(path(noon_of(path)).elevation), 48.6, 0.1);
    }
}

TEST(SunPath, NearestIsTheMomentItself) {
    const SunPath path = sun_path(place(47.0, 8.0), {2026, 6, 21}, 2.0);
    const auto day = hours_above(path, 0.0);
    for (const double hour : {7.25, 13.0, 19.9}) {
        const Approach found = nearest(path, path(hour), *day);
        EXPECT_NEAR(found.hour, hour, 1e-3);
        EXPECT_LT(degrees(found.off), 1e-3);
    }
    // The sun is never in the north. It comes nearest where it rises or sets.
    const Approach far = nearest(path, {0.0, radians(10.0)}, *day);
    EXPECT_GT(degrees(far.off), 40.0);
    EXPECT_TRUE(far.hour == day->from || far.hour == day->to);
}

TEST(SunPath, TheYearFindsTheDay) {
    const GeographicPosition at = place(47.0, 8.0);
    const Sun wanted = sun_path(at, {2026, 4, 12}, 1.0)(16.5);
    const auto days = approaches_in(2026, at, 1.0, wanted);
    ASSERT_EQ(days.size(), 365u);
    // The sun passes twice a year, as many days before the solstice as after it.
    for (const DayApproach& day : days) {
        const long off = std::abs(day_number(day.date) - day_number({2026, 4, 12}));
        const long mirrored = std::abs(day_number(day.date) - day_number({2026, 8, 30}));
        const double angle = degrees(day.approach.off);
        EXPECT_EQ(angle < 1.5, off < 5 || mirrored < 5) << text_of(day.date);
        if (off == 0) {
            EXPECT_LT(angle, 1e-4);
        }
    }
}

TEST(SunPath, AnglesBetweenSuns) {
    EXPECT_NEAR(angle_between({0.0, 0.0}, {radians(90.0), 0.0}), radians(90.0), 1e-12);
    EXPECT_NEAR(angle_between({0.0, radians(80.0)}, {radians(180.0), radians(80.0)}),
                radians(20.0), 1e-12);
    EXPECT_EQ(angle_between({1.0, 0.5}, {1.0, 0.5}), 0.0);
}

TEST(SunPath, EverySunHasAnArcThatARealSunTakes) {
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 15.0)
        for (const double elevation : {0.1, 5.0, 25.0, 60.0, 89.0}) {
            const Sun wanted{radians(azimuth), radians(elevation)};
            const Arc arc = arc_through(wanted);
            EXPECT_LE(std::abs(degrees(arc.declination)), 23.44);
            EXPECT_LE(std::abs(degrees(arc.latitude)), 66.5);
            const SunPath path = sun_path(arc.latitude, arc.declination);
            const auto day = hours_above(path, 0.0);
            ASSERT_TRUE(day);
            EXPECT_LT(degrees(nearest(path, wanted, *day).off), 0.01)
                << azimuth << ' ' << elevation;
            EXPECT_LT(std::sin(path(day->to - 0.01).azimuth), 0.0) << "sets in the west";
        }
}

TEST(SunPath, DatesOfTheCalendar) {
    EXPECT_TRUE(exists({2024, 2, 29}));
    for (const Date date :
         {Date{2026, 2, 29}, Date{2026, 2, 31}, Date{2026, 13, 1}, Date{2026, 4, 0},
          Date{1899, 1, 1}, Date{2101, 1, 1}, Date{2026, -1, 1}, Date{2026, 4, 31}})
        EXPECT_FALSE(exists(date)) << date.year << ' ' << date.month << ' ' << date.day;
    EXPECT_EQ(date_from("2026-06-21"), (Date{2026, 6, 21}));
    for (const char* text : {"", "2026", "2026-6-21", "21.06.2026", "2026-06-2x",
                             "2026-06-211", "-026-06-21", "2026-+6-21"})
        EXPECT_FALSE(date_from(text)) << text;
    EXPECT_EQ(text_of({2026, 6, 21}), "21 June 2026");
    EXPECT_EQ(day_number({1970, 1, 1}), 0);
    EXPECT_EQ(date_of_day(day_number({2026, 12, 31}) + 1), (Date{2027, 1, 1}));
}

TEST(SunPath, ClocksGoRound) {
    EXPECT_EQ(clock_text(17.7), "17:42");
    EXPECT_EQ(clock_text(23.999), "00:00");
    EXPECT_EQ(clock_text(-1.5), "22:30");
    EXPECT_EQ(clock_text(25.25), "01:15");
}

}  // namespace
}  // namespace cydonia
