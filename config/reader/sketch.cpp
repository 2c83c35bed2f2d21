#include <fmt/format.h>

#include <algorithm>

#include "config/reader/elevation_models.h"
#include "config/reader/readers.h"
#include "config/reader/texture.h"

namespace cydonia::config {

using sketch::Feature;
using sketch::Hold;
using sketch::NoiseKind;
using sketch::Options;
using sketch::RoughRegion;
using sketch::Silhouette;
using sketch::View;
using sketch::Way;

namespace {

constexpr std::size_t kMostLandforms = 256, kMostRegions = 256, kMostHandles = 256;
constexpr std::size_t kLongestId = 256;
constexpr Number kHeight{from(-1e5, 1e5)};
constexpr LengthUnit kReach{above(0.0)};

constexpr Name<NoiseKind> kNoises[] = {{"wavelet", NoiseKind::kWavelet},
                                       {"texture", NoiseKind::kTexture},
                                       {"detail", NoiseKind::kDetail}};

void read_way(Table& t, Way& way, std::size_t least, bool needed = true) {
    t.field("points", way.points, LengthUnit{});
    t.field("drawing", way.drawing, File{});
    t.field("id", way.id, Text{kLongestId});
    t.check(t.has("points") != t.has("drawing") || (!needed && !t.has("points")),
            {"points", "drawing"}, "needs exactly one of points and drawing");
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

void read(Table& t, View& view, const std::vector<std::string>& names) {
    t.required("drawing", view.drawing, File{});
    t.field("id", view.id, Text{kLongestId});
    t.field("mouse", view.mouse, Flag{});
    t.field("through", view.through, Text{kLongestId});
    for (const std::string& name : view.through)
        t.check(std::ranges::find(names, name) != names.end() && name != names.back(),
                {"through"},
                fmt::format("there is no landform '{}' before this one", name));
}

void read(Table& t, Way& way) { read_way(t, way, 2); }

void read(Table& t, Feature& feature, std::vector<std::string>& names) {
    read_name(t, feature.name, "landform", names.size() + 1, names);
    t.table("view", feature.view, names);
    read_way(t, feature.way, 2, !feature.view);
    t.field("height", feature.height, kHeight);
    t.field("relative", feature.relative, Flag{});
    t.field("boundary", feature.boundary, kReach);
    t.table("boundary_curve", feature.boundary_curve);
    t.only_if(!t.has("boundary"), {"boundary_curve"}, "a landform without a boundary");
    t.tables("hold", feature.holds, kMostHandles);
    t.check(std::ranges::adjacent_find(feature.holds,
                                       [](const Hold& a, const Hold& b) {
                                           return a.at >= b.at;
                                       }) == feature.holds.end(),
            {"hold"}, "'at' must rise from one to the next");
    t.table("silhouette", feature.silhouette);
    t.only_if(!feature.view, {"height", "relative", "hold", "silhouette"},
              "a landform without a view");
    const bool held = std::ranges::any_of(
        feature.holds, [](const Hold& hold) { return hold.height.has_value(); });
    t.check(t.has("height") || held || feature.silhouette || feature.view,
            {"height", "silhouette", "view"},
            "needs a height: give height, holds with heights, a silhouette or a view");
}

void read(Table& t, RoughRegion& region, std::vector<std::string>& names) {
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
            "there is nothing to sketch; add a [[terrain.stage.landform]]");
    t.field("levels", o.levels, Whole{1, 10});
    t.field("noise", o.noise, one_of(kNoises));
    t.field("noise_from", o.noise_from, ElevationModel{});
    t.check(o.noise == NoiseKind::kWavelet || o.noise_from, {"noise", "noise_from"},
            "needs noise_from, an elevation model, for that noise");
}

}  // namespace cydonia::config
