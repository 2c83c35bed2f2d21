// Where the features of a distance stage are.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "config/reader/distance.h"
#include "config/reader/readers.h"

namespace cydonia::config {

using namespace distance;

namespace {

constexpr int kMostFeatures = 1000000;
constexpr std::size_t kMostLevels = 64, kMostDistances = 64;
constexpr std::string_view kApproximate = "approximate";

constexpr std::string_view kBefore = " before this one";

bool rises(const std::array<Length, 2>& range) {
    const auto [least, most] = range;
    const bool same_unit = (least.metres == 0.0 && most.metres == 0.0) ||
                           (least.fraction == 0.0 && most.fraction == 0.0);
    return same_unit && least.metres <= most.metres && least.fraction <= most.fraction;
}

bool descend(const std::vector<Terraces::Level>& levels) {
    return std::ranges::adjacent_find(levels, [](const auto& far, const auto& near) {
               return near.range[1] > far.range[0];
           }) == levels.end();
}

}  // namespace

void read(Table& t, Placement::Away& away, const Names& names) {
    t.required("from", away.from, GroupName{names.groups, kBefore});
    t.required("distance", away.distance, LengthUnit{above(0.0)});
}

void read(Table& t, Placement& placement, const Names& names) {
    t.field("count", placement.count, Whole{0, kMostFeatures});
    t.field("density", placement.density, Number{above_to(0.0, kMostFeatures)});
    t.field("keep_out", placement.keep_out, File{});
    t.field("apart", placement.apart, LengthUnit{at_least(0.0)});
    t.tables("away", placement.away, kMostDistances, names);
    t.check(t.has("count") != t.has("density"), {"density", "count"},
            "needs exactly one of count and density");
}

void read(Table& t, Strokes& strokes) {
    t.required("image", strokes.image, File{});
    t.field("colour", strokes.colour, Colour{});
}

void read(Table& t, Peaks& peaks, const Names& names) { read(t, peaks.placement, names); }

void read(Table& t, Circles& circles, const Names& names) {
    read(t, circles.placement, names);
    t.field("radius", circles.radius, LengthUnit{above(0.0)});
    t.field("roughness", circles.roughness, Number{Range{0.0, 1.0, true, false}});
    t.check(rises(circles.radius), {"radius"},
            "must go from least to most, both in metres or both as shares of the width");
}

void read(Table& t, Edges& edges) {
    t.required("image", edges.image, File{});
    t.field("threshold", edges.threshold, Number{above_to(0.0, 1.0)});
}

void read(Table& t, Terraces::Level& level) {
    t.required("range", level.range, Number{from(0.0, 1.0)});
    t.required("cost", level.cost, LengthUnit{at_least(0.0)});
    t.check(level.range[0] < level.range[1], {"range"}, "must go from least to most");
}

void read(Table& t, Terraces& terraces) {
    t.required("image", terraces.image, File{});
    t.tables("level", terraces.levels, kMostLevels);
    t.check(!terraces.levels.empty(), {"level"}, "needs at least one level");
    t.check(descend(terraces.levels), {"level"},
            "levels must go from the farthest from the strokes to the nearest and not "
            "overlap");
}

void read(Table& t, Lip& lip) {
    t.required("image", lip.image, File{});
    t.field("distance", lip.distance, LengthUnit{above(0.0)});
}

void read(Table& t, Ridges& ridges, const Names& names) {
    t.field("count", ridges.count, Whole{0, kMostFeatures});
    t.field("cost_factor", ridges.cost_factor, Number{from(0.0, 1.0)});
    t.field("reach", ridges.reach, LengthUnit{above(0.0)});
    t.field("from", ridges.from, GroupName{names.groups, " up to this one"});
}

namespace {

// The six ways to state where features are; a group uses one of them.
template <class Where, class... Context>
void read_where(Table& t, std::string_view key, Group& group,
                std::vector<std::string_view>& found, const Context&... names) {
    if (t.has(key)) found.push_back(key);
    std::optional<Where> where;
    t.table(key, where, names...);
    if (where) group.where = std::move(*where);
}

void read_where(Table& t, Group& group, const Names& names) {
    std::vector<std::string_view> found;
    read_where<Strokes>(t, "strokes", group, found);
    read_where<Peaks>(t, "peaks", group, found, names);
    read_where<Circles>(t, "circles", group, found, names);
    read_where<Edges>(t, "edges", group, found);
    read_where<Terraces>(t, "terraces", group, found);
    read_where<Lip>(t, "lip", group, found);
    t.check(
        found.size() == 1, {"strokes", "peaks", "circles", "edges", "terraces", "lip"},
        fmt::format("needs exactly one of strokes, peaks, circles, edges, terraces and "
                    "lip; found {}",
                    found.empty() ? "none" : fmt::format("{}", fmt::join(found, ", "))));
}

void read_name(Table& t, Group& group, const Names& names) {
    group.name = fmt::format("group-{}", names.groups.size() + 1);
    t.field("name", group.name, Word{});
    t.check(group.name != kApproximate, {"name"},
            "'approximate' is a word of share_of; choose another name");
    t.check(std::ranges::find(names.groups, group.name) == names.groups.end(), {"name"},
            fmt::format("'{}' is taken by another one", group.name));
}

}  // namespace

void read(Table& t, Group& group, Names& names) {
    read_name(t, group, names);
    read_where(t, group, names);
    t.table("cost", group.cost, names, Sign::kNotNegative);
    t.field("profile", group.profile, OneOrMore{ProfileName{names.profiles}});
    t.field("other_side", group.other_side, ProfileName{names.profiles});
    names.groups.push_back(group.name);
    t.table("ridges", group.ridges, names);

    t.only_if(!std::holds_alternative<Terraces>(group.where), {"cost"},
              "features other than terraces, whose levels have theirs");
    t.only_if(names.random_weights, {"profile", "other_side"},
              "a stage without edge_weights");
    t.only_if(!group.profile.empty(), {"other_side"}, "a group with a profile");
}

}  // namespace cydonia::config
