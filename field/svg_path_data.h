#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "field/bezier.h"

namespace cydonia {

// One outline of a drawing: the point where the pen is put down, and cubic Bezier curves
// from there. Straight ones have their handles on the line.
struct SvgOutline {
    Point2 start{};
    std::vector<std::array<Point2, 3>> curves;
    bool closed = false;
};

// The outlines of a path's d attribute (SVG 1.1, section 8.3). Throws bad_request that
// says where it cannot be read.
std::vector<SvgOutline> outlines_of(std::string_view data);

// add_line() appends a straight line to `to`, add_arc() a part of an ellipse with radii r
// whose x axis is turned by `turn` degrees (SVG 1.1, F.6).
void add_line(SvgOutline& outline, const Point2& to);
void add_arc(SvgOutline& outline, Point2 r, double turn, bool large, bool sweep,
             const Point2& to);

}  // namespace cydonia
