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

// On the Earth; latitude north and longitude east are positive.
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

// What the calendar makes of the sun, wherever one stands.
struct SolarTime {
    double declination;  // radians
    double equation;     // of time, minutes: a sundial less a clock
};
SolarTime solar_time(const Date& date, double utc_hour);

// A sun of this declination, `hour_angle` after noon (a full turn a day), from a
// latitude.
Sun sun_over(double latitude, double declination, double hour_angle);
// What the air lifts a sun that stands there without air; NOAA's approximation.
double refraction(double elevation);
// With `air` as it is seen and as it throws shadows, lifted by refraction.
Sun sun_at(const GeographicPosition& place, const Date& date, double utc_hour,
           bool air = true);

// The angle between two suns as seen from the ground.
double angle_between(const Sun& a, const Sun& b);

// The sun over a day by the hour of a clock; any hour, also of the days before and after.
using SunPath = std::function<Sun(double hour)>;
// `time_zone`: hours that the clock is ahead of UTC.
SunPath sun_path(const GeographicPosition& place, const Date& date, double time_zone);
// By a sundial, without air.
SunPath sun_path(double latitude, double declination);

// When the sun stands highest in the hours 0 to 24.
double noon_of(const SunPath& path);

// The hours around noon, half a day either way, in which the sun stands at least so high;
// none when it never does. The whole day where it never sinks below.
struct Hours {
    double from, to;
};
std::optional<Hours> hours_above(const SunPath& path, double elevation);

// When within `hours` the sun comes nearest to where it is wanted, and how near.
struct Approach {
    double hour = 0.0;
    Sun sun;           // then
    double off = 0.0;  // radians from where it is wanted
};
Approach nearest(const SunPath& path, const Sun& wanted, const Hours& hours);

// The nearest of every day of a year, above the horizon; days without sun are left out.
struct DayApproach {
    Date date;
    Approach approach;
};
std::vector<DayApproach> approaches_in(int year, const GeographicPosition& place,
                                       double time_zone, const Sun& wanted);

// A latitude and a season whose sun passes through `sun`: declinations are those of the
// real sun, the latitude the one nearest to 40 degrees north or south.
struct Arc {
    double latitude, declination;
};
Arc arc_through(const Sun& sun);

}  // namespace cydonia
