#include <fmt/format.h>

#include <algorithm>

#include "config/reader/readers.h"

namespace cydonia::config {
namespace {

constexpr Name<FramesSpec::Sweep> kSweeps[] = {{"day", FramesSpec::Sweep::kDay}};
constexpr Name<FramesSpec::Pace> kPaces[] = {
    {"lingering", FramesSpec::Pace::kLingering},
    {"even", FramesSpec::Pace::kEven},
};

// The unit of a day: a TOML date such as 2026-06-21, or the same as text.
struct Day {
    static constexpr bool kVaries = false;
    Date read(const Value& value, Files&) const;
    std::string text(const Date& date) const {
        return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
    }
    std::string schema() const {
        return schema::text(10, "^[0-9]{4}-[0-9]{2}-[0-9]{2}$", "a day");
    }
};

Date Day::read(const Value& value, Files&) const {
    const auto* moment = std::get_if<Value::Moment>(&value.data);
    const auto* text = std::get_if<std::string>(&value.data);
    const std::string written = moment ? moment->date : text ? *text : "";
    const auto date = date_from(written);
    if (!date)
        throw Wrong{fmt::format("expected a date such as 2026-06-21, found {}",
                                described(value))};
    if (date->year < kFirstYear || date->year > kLastYear)
        throw Wrong{fmt::format("the year {} is out of range; it must be {} to {}",
                                date->year, kFirstYear, kLastYear)};
    if (!exists(*date)) throw Wrong{fmt::format("there is no day {}", written)};
    return *date;
}

// The unit of the name of one of the scene's cameras.
struct CameraName {
    const std::vector<render::CameraOptions>& cameras;
    static constexpr bool kVaries = false;
    std::string read(const Value& value, Files& files) const;
    std::string text(const std::string& name) const {
        return name.empty() ? "none" : name;
    }
    std::string schema() const { return Word{}.schema(); }
};

std::string CameraName::read(const Value& value, Files& files) const {
    const std::string name = Word{}.read(value, files);
    std::vector<std::string> known;
    for (const auto& camera : cameras) known.push_back(camera.name);
    if (cameras.empty())
        known = {"overhead", "oblique"};  // the cameras that such a scene gets
    if (std::ranges::find(known, name) == known.end())
        throw Wrong{fmt::format("no camera '{}'{}", name, suggestion(name, known))};
    return name;
}

void read(Table& t, FramesSpec& frames,
          const std::vector<render::CameraOptions>& cameras) {
    t.field("sweep", frames.sweep, one_of(kSweeps));
    t.field("count", frames.count, Whole{1, kMostFrames});
    t.field("rate", frames.rate, Number{from(1.0, 240.0)});
    t.field("pace", frames.pace, one_of(kPaces));
    t.field("hold", frames.hold, Number{from(0.0, 60.0)});
    t.field("camera", frames.camera, CameraName{cameras});
    t.table("place", frames.place);
    t.field("date", frames.date, Day{});
    t.field("time_zone", frames.time_zone, Number{from(-12.0, 14.0)});

    t.check(!frames.place || frames.date, {"place"},
            "a place needs a date, such as date = 2026-06-21");
    t.only_if(t.has("place"), {"date", "time_zone"}, "a place");
}

}  // namespace

void read(Table& t, GeographicPosition& place) {
    t.required("latitude", place.latitude, Degrees{from(-90.0, 90.0)});
    t.required("longitude", place.longitude, Degrees{from(-180.0, 180.0)});
}

void read(Table& t, FramesTable& out, const std::vector<render::CameraOptions>& cameras) {
    read(t, out.frames, cameras);
    out.text = t.record().text();
}

}  // namespace cydonia::config
