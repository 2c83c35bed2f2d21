#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "field/sun.h"

namespace cydonia {

// Where the sun stands by place, date and time: the formulas of NOAA's solar calculator
// (gml.noaa.gov/grad/solcalc), which are those of J. Meeus, Astronomical Algorithms, 2nd
// ed. 1998, chapters 22, 25 and 28. Within 0.02 degrees for dates from 1900 to 2100.
// Angles in radians, hours as a clock shows them; the Gregorian calendar.

// A position on the Earth in radians: latitude north and longitude east are positive.
struct GeographicPosition {
    double latitude = 0.0, longitude = 0.0;
    bool operator==(const GeographicPosition&) const = default;
};

struct Date {
    int year = 2000, month = 1, day = 1;
    bool operator==(const Date&) const = default;
};
inline constexpr int kFirstYear = 1900, kLastYear = 2100;
bool exists(const Date& date);  // 29 February only in leap years; within the years above
std::optional<Date> date_from(const std::string& text);  // "2026-06-21"
std::string text_of(const Date& date);                   // "21 June 2026"
long day_number(const Date& date);                       // days since 1 January 1970
Date date_of_day(long day_number);

// "17:42"; hours beyond the day are those of the day before or after.
std::string clock_text(double hour);

// What the date alone decides of the sun, for every position on the Earth.
struct SolarTime {
    double declination;  // radians
    double equation;     // of time, minutes: a sundial less a clock
};
SolarTime solar_time(const Date& date, double utc_hour);

// The sun of this declination as seen from a latitude, `hour_angle` after noon; a full
// turn is a day.
Sun sun_over(double latitude, double declination, double hour_angle);
// The angle by which the air lifts a sun that would stand at `elevation` without air
// (NOAA's approximation).
double refraction(double elevation);
// The sun at a date and hour. With `air` it is lifted by refraction, as it is seen and as
// it casts shadows.
Sun sun_at(const GeographicPosition& place, const Date& date, double utc_hour,
           bool air = true);

// The angle between two suns as seen from the ground.
double angle_between(const Sun& a, const Sun& b);

// The sun by the hour of a clock. Hours before 0 and after 24 belong to the days before
// and after.
using SunPath = std::function<Sun(double hour)>;
// `time_zone`: hours that the clock is ahead of UTC.
SunPath sun_path(const GeographicPosition& place, const Date& date, double time_zone);
// The same by a sundial, without air.
SunPath sun_path(double latitude, double declination);

// The hour from 0 to 24 at which the sun stands highest.
double noon_of(const SunPath& path);

// The hours around noon, within half a day either way, in which the sun stands at least
// at `elevation`: none when it never does, the whole day when it never sinks below.
struct Hours {
    double from, to;
};
std::optional<Hours> hours_above(const SunPath& path, double elevation);

// The hour at which the sun comes nearest to the wanted one, and how near it comes.
struct Approach {
    double hour = 0.0;
    Sun sun;           // then
    double off = 0.0;  // radians from where it is wanted
};
Approach nearest(const SunPath& path, const Sun& wanted, const Hours& hours);

// The nearest approach on every day of a year, with the sun above the horizon. Days
// without sun are left out.
struct DayApproach {
    Date date;
    Approach approach;
};
std::vector<DayApproach> approaches_in(int year, const GeographicPosition& place,
                                       double time_zone, const Sun& wanted);

// A latitude and a declination whose sun passes through `sun`. The declination is one
// that the real sun reaches, and the latitude is as near to 40 degrees north or south as
// possible.
struct Arc {
    double latitude, declination;
};
Arc arc_through(const Sun& sun);

}  // namespace cydonia
