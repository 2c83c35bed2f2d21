#include <fmt/format.h>

#include <algorithm>

#include "config/reader/readers.h"
#include "config/reader/texture.h"

namespace cydonia::config {

using sketch::Feature;
using sketch::Hold;
using sketch::Options;
using sketch::Region;
using sketch::Silhouette;
using sketch::Way;

namespace {

constexpr std::size_t kMostLandforms = 256, kMostRegions = 256, kMostHandles = 256;
constexpr std::size_t kLongestId = 256;
constexpr Number kHeight{from(-1e5, 1e5)};
constexpr LengthUnit kReach{above(0.0)};

void read_way(Table& t, Way& way, std::size_t least) {
    t.field("points", way.points, LengthUnit{});
    t.field("drawing", way.drawing, File{});
    t.field("id", way.id, Text{kLongestId});
    t.check(t.has("points") != t.has("drawing"), {"points", "drawing"},
            "needs exactly one of points and drawing");
    t.check(!t.has("points") || way.points.size() >= least, {"points"},
            fmt::format("needs at least {} points", least));
    t.only_if(t.has("drawing"), {"id"}, "a way with a drawing");
}

}  // namespace

void read(Table& t, Hold& hold) {
    t.required("at", hold.at, Number{from(0.0, 1.0)});
    t.field("height", hold.height, kHeight);
    t.field("boundary", hold.boundary, kReach);
}

void read(Table& t, Silhouette& silhouette) {
    t.required("drawing", silhouette.drawing, File{});
    t.field("id", silhouette.id, Text{kLongestId});
    t.field("bottom", silhouette.bottom, kHeight);
    t.field("top", silhouette.top, kHeight);
    t.check(silhouette.top > silhouette.bottom, {"top", "bottom"},
            "the page's top must be higher than its bottom");
    t.field("mouse", silhouette.mouse, Flag{});
}

void read(Table& t, Feature& feature, std::vector<std::string>& names) {
    read_name(t, feature.name, "landform", names.size() + 1, names);
    read_way(t, feature.way, 2);
    t.field("height", feature.height, kHeight);
    t.field("relative", feature.relative, Flag{});
    t.field("boundary", feature.boundary, kReach);
    t.tables("hold", feature.holds, kMostHandles);
    t.check(std::ranges::adjacent_find(feature.holds,
                                       [](const Hold& a, const Hold& b) {
                                           return a.at >= b.at;
                                       }) == feature.holds.end(),
            {"hold"}, "'at' must rise from one to the next");
    t.table("silhouette", feature.silhouette);
    const bool held = std::ranges::any_of(
        feature.holds, [](const Hold& hold) { return hold.height.has_value(); });
    t.check(t.has("height") || held || feature.silhouette, {"height", "silhouette"},
            "needs a height, of its own, in its holds or by a silhouette");
}

void read(Table& t, Region& region, std::vector<std::string>& names) {
    read_name(t, region.name, "region", names.size() + 1, names);
    read_way(t, region.way, 3);
    t.table("noise", region.noise);
    t.field("length", region.length, kReach);
}

void read(Table& t, Options& o) {
    std::vector<std::string> names;
    t.tables("landform", o.features, kMostLandforms, names);
    t.tables("region", o.regions, kMostRegions, names);
    t.check(!o.features.empty() || !o.regions.empty(), {"landform", "region"},
            "nothing is sketched; add [[terrain.stage.landform]]");
    t.field("levels", o.levels, Whole{1, 10});
}

}  // namespace cydonia::config
