// The points and curves of a texture stage.

#include <fmt/format.h>

#include <algorithm>

#include "config/reader/texture.h"

namespace cydonia::config {

using geometry::Curve;
using geometry::Handle;
using geometry::Point;

namespace {

constexpr std::size_t kMostHandles = 256;
constexpr std::size_t kLongestId = 256;
constexpr Number kHeight{from(-1e5, 1e5)};
constexpr Number kGradient{from(-100.0, 100.0)};
constexpr LengthUnit kRadius{above(0.0)};

}  // namespace

void read(Table& t, Handle& handle) {
    t.required("at", handle.at, Number{from(0.0, 1.0)});
    t.field("height", handle.height, kHeight);
    t.field("gradient", handle.gradient, kGradient);
    t.field("area", handle.area, kRadius);
}

namespace {

void read_course(Table& t, Curve& curve) {
    t.field("points", curve.points, LengthUnit{});
    t.field("drawing", curve.drawing, File{});
    t.field("id", curve.id, Text{kLongestId});
    t.check(t.has("points") != t.has("drawing"), {"points", "drawing"},
            "needs exactly one of points and drawing");
    t.check(!t.has("points") || curve.points.size() >= 2, {"points"},
            "a curve needs at least two points; one alone is a [[terrain.stage.point]]");
    t.only_if(t.has("drawing"), {"id"}, "a curve with a drawing");
}

void read_handles(Table& t, Curve& curve) {
    t.tables("handle", curve.handles, kMostHandles);
    const auto& handles = curve.handles;
    t.check(std::ranges::adjacent_find(
                handles, [](const Handle& a, const Handle& b) { return a.at >= b.at; }) ==
                handles.end(),
            {"handle"}, "'at' must rise from one handle to the next");
}

}  // namespace

void read(Table& t, Point& point, TextureNames& names) {
    read_name(t, point.name, "point", names.constraints.size() + 1, names.constraints);
    t.required("at", point.at, LengthUnit{});
    t.required("height", point.height, kHeight);
    t.field("relative", point.relative, Flag{});
    t.field("gradient", point.gradient, kGradient);
    t.field("radius", point.radius, kRadius);
}

void read(Table& t, Curve& curve, TextureNames& names) {
    read_name(t, curve.name, "curve", names.constraints.size() + 1, names.constraints);
    read_course(t, curve);
    t.field("height", curve.height, kHeight);
    t.field("relative", curve.relative, Flag{});
    t.field("gradient", curve.gradient, kGradient);
    t.field("area", curve.area, kRadius);
    read_handles(t, curve);
    const bool handled = std::ranges::any_of(
        curve.handles, [](const Handle& handle) { return handle.height.has_value(); });
    t.check(t.has("height") || handled, {"height", "handle"},
            "needs a height: give height, or heights in its handles");
}

}  // namespace cydonia::config
