#include "synth/distance/places.h"

#include <unistd.h>

#include <algorithm>

#include "field/error.h"
#include "field/random.h"
#include "field/sample.h"
#include "field/strokes.h"

namespace cydonia::distance {
namespace {

constexpr int kTries = 1000;  // of a feature

void check_memory(double count, const std::string& name) {
    const double needed = count * (sizeof(Shape) + 4.0 * sizeof(SitePoint));
    const double present = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                           static_cast<double>(sysconf(_SC_PAGE_SIZE));
    if (needed > present) {
        throw bad_request(
            "group '{}': {:.0f} features would take {:.1f} GiB and this machine has "
            "{:.1f}: lower count or density",
            name, count, needed / 0x1p30, present / 0x1p30);
    }
}

int count_of(const Placement& placement, const std::string& name, const Site& site) {
    if (placement.count < 0) {
        throw bad_request("group '{}': count is {}: it must be at least 0", name,
                          placement.count);
    }
    if (!placement.density) {
        check_memory(placement.count, name);
        return placement.count;
    }
    if (!(*placement.density >= 0.0)) {
        throw bad_request("group '{}': density is {}: it must be at least 0", name,
                          *placement.density);
    }
    if (placement.count > 0) {
        throw bad_request("group '{}': give a count or a density, not both", name);
    }
    const double count = std::round(*placement.density * site.width * site.depth * 1e-6);
    check_memory(count, name);
    if (count > 1e9) throw bad_request("group '{}': density is too great", name);
    return static_cast<int>(count);
}

double distance_in(const Length& length, const Site& site, const std::string& name,
                   const char* what) {
    const double metres = length.in(site.width);
    if (!(metres >= 0.0)) {
        throw bad_request("group '{}': {} is {} m: it must be at least 0", name, what,
                          metres);
    }
    return metres;
}

// Tells whether a place is clear of what it must keep away from.
class Room {
  public:
    Room(const Placement& placement, const std::string& name, const Site& site,
         const std::vector<PlacedGroup>& before)
        : site_(site),
          apart_(distance_in(placement.apart, site, name, "apart")),
          own_(std::max(apart_, 1e-3 * site.width)) {
        if (placement.keep_out) {
            light_ = read_grey_at(*placement.keep_out, (site.columns + 1) / 2,
                                  (site.rows + 1) / 2);
        }
        for (const Placement::Away& away : placement.away) {
            const double distance =
                distance_in(away.distance, site, name, "away.distance");
            Others& others =
                others_.emplace_back(distance, PointIndex(std::max(distance, 1.0)));
            const std::string asked = "group '" + name + "': away.from";
            for (const Shape& shape : group_before(before, away.from, asked).shapes) {
                for (const SitePoint& p : shape.places) others.places.add(p.x, p.y, 0);
            }
        }
    }

    // Where the picture is grey, `chance` in [0, 1) decides.
    bool has(double x, double y, double chance) const {
        if (!light_.empty() && chance >= light_at(x, y)) return false;
        if (apart_ > 0.0 && own_.any_within(x, y, apart_)) return false;
        return std::ranges::none_of(others_, [&](const Others& others) {
            return others.places.any_within(x, y, others.distance);
        });
    }
    void take(double x, double y) { own_.add(x, y, 0); }

  private:
    struct Others {
        double distance;
        PointIndex places;
    };

    float light_at(double x, double y) const {
        return bilinear(light_, x / site_.width * light_.width() - 0.5,
                        y / site_.depth * light_.height() - 0.5);
    }

    const Site& site_;
    double apart_;
    Field<float> light_;
    PointIndex own_;
    std::vector<Others> others_;
};

}  // namespace

double PlacedGroup::highest_cost() const {
    float highest = 0.0f;
    for (const Shape& shape : shapes) {
        for (const SitePoint& place : shape.places)
            highest = std::max(highest, place.cost);
    }
    return highest;
}

const PlacedGroup& group_before(const std::vector<PlacedGroup>& before,
                                const std::string& name, const std::string& asked) {
    const auto found = std::ranges::find(before, name, &PlacedGroup::name);
    if (found == before.end()) {
        throw bad_request("{} names '{}', and no group before it has that name", asked,
                          name);
    }
    return *found;
}

std::vector<SitePoint> random_places(const Placement& placement, const std::string& name,
                                     const Site& site,
                                     const std::vector<PlacedGroup>& before) {
    const int count = count_of(placement, name, site);
    Room room(placement, name, site, before);
    std::vector<SitePoint> places;
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < kTries && static_cast<int>(places.size()) == i; ++k) {
            const std::uint64_t h =
                hash_of({site.seed, key("place"), key_of(name),
                         static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(k)});
            const double x = unit(mix(h ^ 1)) * site.width;
            const double y = unit(mix(h ^ 2)) * site.depth;
            if (!room.has(x, y, unit(mix(h ^ 3)))) continue;
            room.take(x, y);
            places.push_back({static_cast<float>(x), static_cast<float>(y)});
        }
        if (static_cast<int>(places.size()) == i) {
            throw bad_request(
                "group '{}': found room for {} of {} features: lower count, apart or the "
                "distances of away, or clear some of keep_out",
                name, i, count);
        }
    }
    return places;
}

}  // namespace cydonia::distance
