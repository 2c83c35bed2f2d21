#pragma once

#include <string>
#include <vector>

#include "synth/geometry/ground.h"
#include "synth/geometry/options.h"
#include "synth/geometry/plane.h"

namespace cydonia::geometry {

// A curve on the ground as straight lines too short to be seen. Positions are metres from
// the terrain's south-west corner.
struct Shape {
    std::vector<Point2> points;  // at least two, no two in a row equal
    std::vector<double> along;   // metres along the curve to each
    std::vector<Point2>
        tangents;         // at each point, of length 1: the mean of its two lines'
    bool closed = false;  // the last point is the first

    double length() const { return along.back(); }
    int segments() const { return static_cast<int>(points.size()) - 1; }
    Point2 at(double metres_along) const;
    Box box() const;
};

// The straight lines between points. Throws bad_request, which names `name`, when they
// have no length.
Shape shape_through(std::vector<Point2> points, const std::string& name);

// A smooth curve through points: centripetal Catmull-Rom, which makes no loops and no
// cusps where points lie unevenly (Yuksel, Schaefer and Keyser 2011). The curve is a ring
// where the last point equals the first.
std::vector<Point2> smooth_through(const std::vector<Point2>& points, double tolerance);

struct NamedShape {
    std::string name;
    Shape shape;
};

// The shapes that one curve's options describe: a single one, or one for each path of a
// drawing. Throws bad_request.
std::vector<NamedShape> shapes_of(const Curve& curve, const Ground& ground);

}  // namespace cydonia::geometry
