#include "field/sun_path.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace cydonia {
namespace {

using std::numbers::pi;

// The obliquity of the ecliptic bounds the sun's declination.
constexpr double kSolstice = radians(23.44);

std::chrono::year_month_day calendar(const Date& date) {
    return std::chrono::year(date.year) /
           std::chrono::month(static_cast<unsigned>(date.month)) /
           std::chrono::day(static_cast<unsigned>(date.day));
}

// Julian centuries since noon of 1 January 2000, which was Julian day 2451545. Universal
// time stands for dynamical time: the minute between them moves the sun by 0.001 degrees.
double julian_century(const Date& date, double utc_hour) {
    const double days = static_cast<double>(day_number(date)) + utc_hour / 24.0;
    constexpr double kDaysTo2000 = 10957.5;  // from the midnight that began 1970
    return (days - kDaysTo2000) / 36525.0;
}

double sine(double degrees_) { return std::sin(radians(degrees_)); }
double cosine(double degrees_) { return std::cos(radians(degrees_)); }

// The place in [from, to] where `f` is smallest: a coarse search finds the step that
// holds it, and trisection refines it, since `f` has a single valley there.
template <class F>
double lowest(const F& f, double from, double to) {
    constexpr int kSteps = 144;  // ten minutes of a day
    const double step = (to - from) / kSteps;
    int best = 0;
    double least = f(from);
    for (int i = 1; i <= kSteps; ++i)
        if (const double value = f(from + i * step); value < least) {
            least = value;
            best = i;
        }
    double low = std::max(from, from + (best - 1) * step);
    double high = std::min(to, from + (best + 1) * step);
    for (int i = 0; i < 40; ++i) {
        const double third = (high - low) / 3.0;
        const bool left = f(low + third) <= f(high - third);
        (left ? high : low) = left ? high - third : low + third;
    }
    // The smallest value may also lie at an end of the search.
    const double middle = 0.5 * (low + high);
    if (f(from) <= f(middle)) return from;
    return f(to) < f(middle) ? to : middle;
}

// Where `f`, which is negative at `below` and not at `above`, becomes zero.
template <class F>
double crossing(const F& f, double below, double above) {
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (below + above);
        (f(middle) < 0.0 ? below : above) = middle;
    }
    return above;
}

}  // namespace

bool exists(const Date& date) {
    return date.year >= kFirstYear && date.year <= kLastYear && date.month >= 1 &&
           date.day >= 1 && calendar(date).ok();
}

std::optional<Date> date_from(const std::string& text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
    const auto number = [&](std::size_t from, std::size_t count, int& out) {
        const char* begin = text.data() + from;
        const auto [end, error] = std::from_chars(begin, begin + count, out);
        return error == std::errc() && end == begin + count && *begin != '-';
    };
    Date date;
    if (!number(0, 4, date.year) || !number(5, 2, date.month) || !number(8, 2, date.day))
        return std::nullopt;
    return date;
}

std::string text_of(const Date& date) {
    constexpr std::array kMonths{"January",   "February", "March",    "April",
                                 "May",       "June",     "July",     "August",
                                 "September", "October",  "November", "December"};
    return fmt::format("{} {} {}", date.day,
                       kMonths.at(static_cast<std::size_t>(date.month - 1)), date.year);
}

long day_number(const Date& date) {
    return std::chrono::sys_days(calendar(date)).time_since_epoch().count();
}

Date date_of_day(long day_number) {
    const std::chrono::year_month_day date{
        std::chrono::sys_days(std::chrono::days(day_number))};
    return {static_cast<int>(date.year()),
            static_cast<int>(static_cast<unsigned>(date.month())),
            static_cast<int>(static_cast<unsigned>(date.day()))};
}

std::string clock_text(double hour) {
    constexpr long kDay = 24 * 60;
    const long minutes = (std::lround(60.0 * hour) % kDay + kDay) % kDay;
    return fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
}

// Meeus 1998, chapter 25 (low accuracy) and equation 28.3; all in degrees.
SolarTime solar_time(const Date& date, double utc_hour) {
    const double t = julian_century(date, utc_hour);
    const double mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = 357.52911 + t * (35999.05029 - 0.0001537 * t);
    const double eccentricity = 0.016708634 - t * (0.000042037 + 0.0000001267 * t);
    const double centre = sine(anomaly) * (1.914602 - t * (0.004817 + 0.000014 * t)) +
                          sine(2.0 * anomaly) * (0.019993 - 0.000101 * t) +
                          sine(3.0 * anomaly) * 0.000289;
    // Corrections for nutation and aberration.
    const double node = 125.04 - 1934.136 * t;
    const double longitude = mean_longitude + centre - 0.00569 - 0.00478 * sine(node);
    const double seconds = 21.448 - t * (46.8150 + t * (0.00059 - t * 0.001813));
    const double obliquity =
        23.0 + (26.0 + seconds / 60.0) / 60.0 + 0.00256 * cosine(node);

    const double half = std::tan(radians(0.5 * obliquity));
    const double y = half * half;
    const double equation =
        y * sine(2.0 * mean_longitude) - 2.0 * eccentricity * sine(anomaly) +
        4.0 * eccentricity * y * sine(anomaly) * cosine(2.0 * mean_longitude) -
        0.5 * y * y * sine(4.0 * mean_longitude) -
        1.25 * eccentricity * eccentricity * sine(2.0 * anomaly);
    // The Earth turns by one degree in four minutes.
    return {std::asin(sine(obliquity) * sine(longitude)), 4.0 * degrees(equation)};
}

// Meeus 1998, equations 13.5 and 13.6, the azimuth counted from north.
Sun sun_over(double latitude, double declination, double hour_angle) {
    const double sin_elevation =
        std::sin(latitude) * std::sin(declination) +
        std::cos(latitude) * std::cos(declination) * std::cos(hour_angle);
    const double south =
        std::cos(hour_angle) * std::sin(latitude) * std::cos(declination) -
        std::sin(declination) * std::cos(latitude);
    const double west = std::sin(hour_angle) * std::cos(declination);
    const double azimuth = std::atan2(west, south) + pi;
    return {azimuth >= 2.0 * pi ? azimuth - 2.0 * pi : azimuth,
            std::asin(std::clamp(sin_elevation, -1.0, 1.0))};
}

double refraction(double elevation) {
    const double h = degrees(elevation), t = std::tan(elevation);
    double seconds = 0.0;
    if (h > 85.0)
        seconds = 0.0;
    else if (h > 5.0)
        seconds = 58.1 / t - 0.07 / std::pow(t, 3) + 0.000086 / std::pow(t, 5);
    else if (h > -0.575)
        seconds = 1735.0 + h * (-518.2 + h * (103.4 + h * (-12.79 + h * 0.711)));
    else
        seconds = -20.772 / t;
    return radians(seconds / 3600.0);
}

Sun sun_at(const GeographicPosition& place, const Date& date, double utc_hour, bool air) {
    const SolarTime time = solar_time(date, utc_hour);
    const double hour_angle =
        radians(15.0 * (utc_hour - 12.0) + time.equation / 4.0) + place.longitude;
    Sun sun = sun_over(place.latitude, time.declination, hour_angle);
    if (air) sun.elevation += refraction(sun.elevation);
    return sun;
}

double angle_between(const Sun& a, const Sun& b) {
    const Vec3 u = direction_to(a), v = direction_to(b);
    return std::atan2(length(cross(u, v)), dot(u, v));
}

SunPath sun_path(const GeographicPosition& place, const Date& date, double time_zone) {
    return [=](double hour) { return sun_at(place, date, hour - time_zone); };
}

SunPath sun_path(double latitude, double declination) {
    return [=](double hour) {
        return sun_over(latitude, declination, radians(15.0 * (hour - 12.0)));
    };
}

double noon_of(const SunPath& path) {
    return lowest([&](double hour) { return -path(hour).elevation; }, 0.0, 24.0);
}

std::optional<Hours> hours_above(const SunPath& path, double elevation) {
    const auto above = [&](double hour) { return path(hour).elevation - elevation; };
    const double noon = noon_of(path);
    if (above(noon) < 0.0) return std::nullopt;
    Hours hours{noon - 12.0, noon + 12.0};
    if (above(hours.from) < 0.0) hours.from = crossing(above, hours.from, noon);
    if (above(hours.to) < 0.0) hours.to = crossing(above, hours.to, noon);
    return hours;
}

Approach nearest(const SunPath& path, const Sun& wanted, const Hours& hours) {
    const auto off = [&](double hour) { return angle_between(path(hour), wanted); };
    const double hour = lowest(off, hours.from, hours.to);
    return {hour, path(hour), off(hour)};
}

std::vector<DayApproach> approaches_in(int year, const GeographicPosition& place,
                                       double time_zone, const Sun& wanted) {
    std::vector<DayApproach> days;
    for (long day = day_number({year, 1, 1}); day < day_number({year + 1, 1, 1}); ++day) {
        const Date date = date_of_day(day);
        const SunPath path = sun_path(place, date, time_zone);
        if (const auto hours = hours_above(path, 0.0))
            days.push_back({date, nearest(path, wanted, *hours)});
    }
    return days;
}

// sin(declination) = sin(latitude) sin(elevation) + cos(latitude) cos(elevation)
// cos(azimuth): Meeus 1998, chapter 13.
Arc arc_through(const Sun& sun) {
    constexpr double kLiked = 40.0, kFarthest = 66.5;  // latitudes, degrees
    const double up = std::sin(sun.elevation);
    const double north = std::cos(sun.elevation) * std::cos(sun.azimuth);
    std::optional<Arc> best;
    double least = 0.0;
    for (double latitude = kFarthest; latitude >= -kFarthest; latitude -= 0.125) {
        const double a = radians(latitude);
        const double declination = std::asin(std::sin(a) * up + std::cos(a) * north);
        const double dislike = std::abs(std::abs(latitude) - kLiked);
        const bool real = std::abs(declination) <= kSolstice;
        if (real && (!best || dislike < least)) {
            best = Arc{a, declination};
            least = dislike;
        }
    }
    // Only a sun on the horizon in the north or south leads beyond this.
    const double side = north > 0.0 ? -1.0 : 1.0;
    return best.value_or(Arc{side * radians(kFarthest), -side * kSolstice});
}

}  // namespace cydonia
