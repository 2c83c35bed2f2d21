#include "app/sequence/day.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "field/error.h"
#include "field/sun_path.h"

namespace cydonia {
namespace {

// Lower suns light nothing but crests.
constexpr double kLowest = radians(2.0);
// So near to where it is wanted the sun shows the image; a degree moves the end of a
// shadow by a twentieth of its length at an elevation of 25.
constexpr double kNear = radians(1.0);
// Farther than this nothing of it is to be seen: the day is filmed around noon.
constexpr double kGlimpsed = radians(5.0);
// Nearer than this is there: what a camera sees of the sun is half a degree wide.
constexpr double kThere = radians(0.02);

// A path of the sun, and how its hours are told.
struct Course {
    SunPath path;
    std::string clock;  // " (UTC+2)", " by a sundial"
    bool real = false;  // of a place and date
};

double zone_of(const config::FramesSpec& frames) {
    const double by_longitude = std::round(degrees(frames.place->longitude) / 15.0);
    return frames.time_zone.value_or(by_longitude);
}

std::string zone_text(double hours) {
    const long minutes = std::lround(60.0 * std::abs(hours));
    std::string text = fmt::format("UTC{}{}", hours < 0.0 ? '-' : '+', minutes / 60);
    if (minutes % 60 != 0) text += fmt::format(":{:02}", minutes % 60);
    return text;
}

Course real_course(const config::FramesSpec& frames) {
    const double zone = zone_of(frames);
    return {sun_path(*frames.place, *frames.date, zone),
            fmt::format(" ({})", zone_text(zone)), true};
}

Course arc_course(const Sun& sun) {
    const Arc arc = arc_through(sun);
    return {sun_path(arc.latitude, arc.declination), " by a sundial", false};
}

// As low as the sun of the image, at least.
double lowest_sun(const std::vector<ShadowImage>& images) {
    return images.empty() ? kLowest
                          : std::min(kLowest, 0.5 * images.front().sun.elevation);
}

// From the first hour to the last, through the hour of the key shot.
std::vector<double> hours_of(const Hours& day, double key_hour, int key, int count,
                             config::FramesSpec::Pace pace) {
    // The sun slows down to the image and speeds up from it: 7 frames of 48 see it within
    // 5 degrees, where an even pace has 2.
    const double power = pace == config::FramesSpec::Pace::kLingering ? 1.5 : 1.0;
    std::vector<double> hours;
    for (int i = 0; i < count; ++i) {
        const double end = i < key ? day.from : day.to;
        const int steps = i < key ? key : count - 1 - key;
        const double part =
            i == key ? 0.0 : std::abs(i - key) / static_cast<double>(steps);
        hours.push_back(key_hour + (end - key_hour) * std::pow(part, power));
    }
    return hours;
}

// The frame whose even hour is the nearest; between the ends where there is room.
int key_frame(const Hours& day, double key_hour, int count) {
    const double length = day.to - day.from;
    const double part = length > 0.0 ? (key_hour - day.from) / length : 0.5;
    const int key = static_cast<int>(std::lround(part * (count - 1)));
    return count < 3 ? std::clamp(key, 0, count - 1) : std::clamp(key, 1, count - 2);
}

// One exposure for the day: half way, in stops, between the light of the key hour and
// that of noon on level ground, so that neither is lost.
double exposure_under(const SunPath& path, double key_hour) {
    const double key = std::sin(path(key_hour).elevation);
    const double noon = std::sin(path(noon_of(path)).elevation);
    return -0.5 * std::log2(noon / key);
}

std::string sun_text(const Sun& sun) {
    double azimuth = std::fmod(degrees(sun.azimuth), 360.0);
    if (azimuth < 0.0) azimuth += 360.0;
    return fmt::format("azimuth {:.1f}, elevation {:.1f}", azimuth,
                       degrees(sun.elevation));
}

std::string place_text(const GeographicPosition& place) {
    const auto side = [](double angle, char positive, char negative) {
        return fmt::format("{:g} {}", std::abs(degrees(angle)),
                           angle < 0.0 ? negative : positive);
    };
    return side(place.latitude, 'N', 'S') + ", " + side(place.longitude, 'E', 'W');
}

// The day of the same year, nearest to the wanted one, on which the image appears; or how
// near the sun comes at all.
std::string other_day(const config::FramesSpec& frames, const Sun& wanted) {
    const double zone = zone_of(frames);
    const auto days = approaches_in(frames.date->year, *frames.place, zone, wanted);
    const auto told = [&](const DayApproach& day) {
        return fmt::format("{} at {} ({:.1f} degrees off)", text_of(day.date),
                           clock_text(day.approach.hour), degrees(day.approach.off));
    };
    const auto far_away = [&](const DayApproach& day) {
        return std::abs(day_number(day.date) - day_number(*frames.date));
    };
    const DayApproach* nearest_day = nullptr;
    const DayApproach* best = nullptr;
    for (const DayApproach& day : days) {
        if (!best || day.approach.off < best->approach.off) best = &day;
        if (day.approach.off <= kNear &&
            (!nearest_day || far_away(day) < far_away(*nearest_day)))
            nearest_day = &day;
    }
    if (nearest_day)
        return "the nearest day on which it appears is " + told(*nearest_day);
    return fmt::format("no day of {} brings it nearer than {}", frames.date->year,
                       told(*best));
}

std::string appearance(const ShadowImage& image, const Course& course,
                       const Approach& approach, const config::FramesSpec& frames) {
    const std::string name = "'" + image.name + "'";
    const std::string day =
        course.real ? fmt::format("on {} ", text_of(*frames.date)) : "";
    const std::string when = clock_text(approach.hour) + course.clock;
    if (approach.off <= kNear)
        return fmt::format(
            "{} appears {}at {}, the sun {:.1f} degrees from where it wants it", name,
            day, when, degrees(approach.off));
    if (!course.real)
        return fmt::format(
            "{} does not appear: its sun, {}, is {:.1f} degrees from the "
            "arc of the first",
            name, sun_text(image.sun), degrees(approach.off));
    return fmt::format(
        "{} does not appear {}at {}: the sun comes nearest at {} and is {:.1f} degrees "
        "from {}; {}; or give the image that hour's sun: {}",
        name, day, place_text(*frames.place), when, degrees(approach.off),
        sun_text(image.sun), other_day(frames, image.sun), sun_text(approach.sun));
}

std::string course_text(const Course& course, const Hours& day,
                        const config::FramesSpec& frames,
                        const std::vector<ShadowImage>& images) {
    const std::string hours = fmt::format("from {} to {}{}", clock_text(day.from),
                                          clock_text(day.to), course.clock);
    if (course.real)
        return fmt::format("the sun of {} at {}, {}", text_of(*frames.date),
                           place_text(*frames.place), hours);
    const Arc arc = arc_through(images.front().sun);
    return fmt::format(
        "the sun of a day at {:.1f} degrees {} when it stands over {:.1f} {}, {}",
        std::abs(degrees(arc.latitude)), arc.latitude < 0.0 ? "south" : "north",
        std::abs(degrees(arc.declination)), arc.declination < 0.0 ? "south" : "north",
        hours);
}

Hours hours_of_day(const Course& course, double lowest,
                   const config::FramesSpec& frames) {
    if (const auto hours = hours_above(course.path, lowest)) return *hours;
    throw bad_request(
        "no day to film: at {} the sun stays below {:g} degrees on {}; choose another "
        "frames.date or frames.place",
        place_text(*frames.place), degrees(lowest), text_of(*frames.date));
}

bool has_image(const config::SceneSpec& scene) {
    return std::ranges::any_of(scene.stages, [](const config::StageSpec& stage) {
        const auto* options = std::get_if<pareidolia::Options>(&stage.options);
        return options && !options->images.empty();
    });
}

}  // namespace

const render::CameraOptions& filming_camera(
    const config::FramesSpec& frames, const std::vector<render::CameraOptions>& cameras) {
    const auto films = [&](const render::CameraOptions& camera) {
        return frames.camera.empty()
                   ? camera.kind == render::CameraOptions::Kind::kOverhead
                   : camera.name == frames.camera;
    };
    const auto found = std::ranges::find_if(cameras, films);
    return found == cameras.end() ? cameras.front() : *found;
}

void check_day(const config::SceneSpec& scene) {
    const config::FramesSpec& frames = scene.frames;
    if (!frames.place && !has_image(scene))
        throw bad_request(
            "nothing to film: the scene has no shadow image whose sun a day could lead "
            "through; give one, or a place and a date in [frames]");
    if (frames.place) hours_of_day(real_course(frames), kLowest, frames);
}

Day day_over(const config::FramesSpec& frames, const render::CameraOptions& camera,
             const std::vector<ShadowImage>& images) {
    const Course course =
        frames.place ? real_course(frames) : arc_course(images.at(0).sun);
    const Hours hours = hours_of_day(course, lowest_sun(images), frames);
    Approach key;
    if (!images.empty()) key = nearest(course.path, images.front().sun, hours);
    const bool glimpsed = !images.empty() && key.off <= kGlimpsed;
    if (!glimpsed) key.hour = noon_of(course.path);

    const int count = frames.count.value_or(config::FramesSpec::kCount);
    const int key_shot = key_frame(hours, key.hour, count);
    Sequence sequence{.name = name_of(Kind::kDay),
                      .camera = camera.name,
                      .shots = {},
                      .exposed_by = {static_cast<std::size_t>(key_shot)},
                      .exposure = exposure_under(course.path, key.hour),
                      .rate = frames.rate,
                      .still = key_shot,
                      .hold = glimpsed ? frames.hold : 0.0};
    const auto pace = glimpsed ? frames.pace : config::FramesSpec::Pace::kEven;
    for (const double hour : hours_of(hours, key.hour, key_shot, count, pace)) {
        Shot shot{camera, clock_text(hour) + course.clock};
        shot.camera.name =
            frame_name(sequence.name, static_cast<int>(sequence.shots.size()));
        shot.camera.sun = course.path(hour);
        sequence.shots.push_back(std::move(shot));
    }
    if (glimpsed && key.off < kThere)
        sequence.shots.at(static_cast<std::size_t>(key_shot)).camera.sun =
            images.front().sun;

    Day day{std::move(sequence), {course_text(course, hours, frames, images)}, true};
    day.appears = images.empty() || key.off <= kNear;
    for (const ShadowImage& image : images)
        day.news.push_back(
            appearance(image, course, nearest(course.path, image.sun, hours), frames));
    return day;
}

}  // namespace cydonia
