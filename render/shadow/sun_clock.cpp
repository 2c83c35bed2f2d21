#include "render/shadow/sun_clock.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "field/parallel.h"
#include "render/shadow/shading.h"

namespace cydonia::render {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHour = kPi / kClockSuns;
constexpr double kLowest = 2.0;     // degrees; a lower sun lights next to nothing
constexpr double kFromRise = 30.0;  // degrees of azimuth from rise and set
constexpr int kAcross = 4, kDown = 3;
constexpr int kClockTile = 320;      // pixels, the longer side
constexpr int kText = 22, kGap = 4;  // pixels
constexpr Rgb8 kPaper{24, 24, 26};
constexpr Rgb8 kWriting{200, 200, 200};
constexpr Rgb8 kOwn{255, 190, 40};

double wrapped(double angle) { return std::remainder(angle, 2.0 * kPi); }

// The great circle of a day: the azimuth and elevation of the highest sun, and whether
// the sun moves clockwise seen from above (it rises in the east).
struct Day {
    double noon, highest;
    bool clockwise;
};

Day day_of(const Sun& own) {
    const bool north = std::cos(own.azimuth) > 0.0;
    const double off = wrapped(own.azimuth - (north ? 0.0 : kPi));
    const double most = radians(90.0 - kFromRise);
    const double kept = std::clamp(off, -most, most);
    return {own.azimuth - kept, std::atan2(std::tan(own.elevation), std::cos(kept)),
            !north};
}

// The sun at `turn`: 0 at its rise, pi at its set.
Sun sun_at(const Day& day, double turn) {
    const double up = std::sin(turn) * std::sin(day.highest);
    const double to_noon = std::sin(turn) * std::cos(day.highest);
    const double to_rise = std::cos(turn);
    const double off = std::atan2(to_rise, to_noon);
    return {day.noon + (day.clockwise ? -off : off),
            std::max(std::asin(std::clamp(up, -1.0, 1.0)), radians(kLowest))};
}

double turn_of(const Day& day, const Sun& own) {
    const double off = wrapped(own.azimuth - day.noon) * (day.clockwise ? -1.0 : 1.0);
    const double level = std::cos(own.elevation);
    return std::atan2(std::hypot(level * std::cos(off), std::sin(own.elevation)),
                      level * std::sin(off));
}

// The light of the sun and of a blue sky, 0 to 1: red, green and blue.
cv::Mat lit(const CheckedLand& land, const Sun& sun, const cv::Size& size) {
    Field<float> light = shading(land.heights, land.spacing, sun);
    const Field<std::uint8_t> cast = land.caster.shadow(sun, 1);
    for (std::size_t i = 0; i < light.size(); ++i)
        if (cast[i]) light[i] = 0.0f;
    cv::Mat direct;
    cv::resize(cv::Mat(light.height(), light.width(), CV_32F, light.data()), direct, size,
               0.0, 0.0, cv::INTER_AREA);
    std::vector<float> tones(direct.begin<float>(), direct.end<float>());
    const auto bright =
        tones.begin() + static_cast<std::ptrdiff_t>(tones.size() * 9 / 10);
    std::nth_element(tones.begin(), bright, tones.end());
    const double exposure = 0.72 / std::max(0.02f, *bright);
    return direct * exposure;
}

// Light from above shades slopes, so that the ground can be read in shadow.
cv::Mat sky_of(const CheckedLand& land, const cv::Size& size) {
    Field<float> light =
        shading(land.heights, land.spacing, {radians(315.0), radians(60.0)});
    cv::Mat sky;
    cv::resize(cv::Mat(light.height(), light.width(), CV_32F, light.data()), sky, size,
               0.0, 0.0, cv::INTER_AREA);
    return sky;
}

class Sheet {
  public:
    Sheet(int tile_width, int tile_height)
        : tile_(tile_width, tile_height),
          picture_(kAcross * (tile_width + kGap) + kGap,
                   kDown * (tile_height + kText + kGap) + kGap, kPaper) {}

    void place(int i, const cv::Mat& direct, const cv::Mat& sky) {
        const cv::Point at = corner(i);
        for (int y = 0; y < tile_.height; ++y)
            for (int x = 0; x < tile_.width; ++x)
                picture_(at.x + x, at.y + y) =
                    colour(direct.at<float>(y, x), sky.at<float>(y, x));
    }
    void label(int i, const Sun& sun, bool own) {
        const cv::Point at = corner(i);
        const Rgb8 c = own ? kOwn : kWriting;
        const cv::Scalar ink(c[0], c[1], c[2]);
        cv::Mat sheet(picture_.height(), picture_.width(), CV_8UC3, picture_.data());
        const double azimuth = std::fmod(degrees(sun.azimuth) + 720.0, 360.0);
        cv::putText(sheet,
                    fmt::format("azimuth {:.0f}, elevation {:.0f}", azimuth,
                                degrees(sun.elevation)),
                    at + cv::Point(2, tile_.height + 16), cv::FONT_HERSHEY_SIMPLEX, 0.45,
                    ink, 1, cv::LINE_AA);
        if (own)
            cv::rectangle(sheet, at - cv::Point(2, 2),
                          at + cv::Point(tile_.width + 1, tile_.height + 1), ink, 2);
    }
    Field<Rgb8> picture() && { return std::move(picture_); }

  private:
    cv::Point corner(int i) const {
        return {kGap + i % kAcross * (tile_.width + kGap),
                kGap + i / kAcross * (tile_.height + kText + kGap)};
    }
    static Rgb8 colour(float direct, float sky) {
        constexpr std::array<float, 3> kSun{1.0f, 0.96f, 0.88f},
            kSky{0.13f, 0.16f, 0.22f};
        Rgb8 result;
        for (std::size_t i = 0; i < 3; ++i) {
            const float light = std::clamp(direct * kSun[i] + sky * kSky[i], 0.0f, 1.0f);
            result[i] = static_cast<std::uint8_t>(255.0f * std::sqrt(light));
        }
        return result;
    }

    cv::Size tile_;
    Field<Rgb8> picture_;
};

}  // namespace

ClockSuns clock_suns(const Sun& own) {
    const Day day = day_of(own);
    const double turn = turn_of(day, own);
    ClockSuns result;
    result.own = std::clamp(static_cast<int>(turn / kHour), 0, kClockSuns - 1);
    for (int i = 0; i < kClockSuns; ++i)
        result.suns[static_cast<std::size_t>(i)] =
            sun_at(day, turn + (i - result.own) * kHour);
    result.suns[static_cast<std::size_t>(result.own)] = own;
    return result;
}

Field<Rgb8> sun_clock(const CheckedLand& land, const Sun& own) {
    const int w = land.heights.width(), h = land.heights.height();
    const double scale = static_cast<double>(kClockTile) / std::max(w, h);
    const cv::Size size(std::max(1, static_cast<int>(std::lround(w * scale))),
                        std::max(1, static_cast<int>(std::lround(h * scale))));
    const cv::Mat sky = sky_of(land, size);
    const ClockSuns clock = clock_suns(own);
    Sheet sheet(size.width, size.height);
    parallel_for(kClockSuns, [&](int i) {
        const Sun& sun = clock.suns[static_cast<std::size_t>(i)];
        sheet.place(i, lit(land, sun, size), sky);
    });
    for (int i = 0; i < kClockSuns; ++i)
        sheet.label(i, clock.suns[static_cast<std::size_t>(i)], i == clock.own);
    return std::move(sheet).picture();
}

}  // namespace cydonia::render
