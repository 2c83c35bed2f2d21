#pragma once

#include <string>
#include <vector>

#include "synth/geometry/ground.h"
#include "synth/geometry/options.h"
#include "synth/geometry/plane.h"

namespace cydonia::texture {

// Where a curve runs, as straight lines so short that nobody sees them: metres from the
// terrain's south-west corner.
struct Shape {
    std::vector<Point2> points;    // at least two, each unlike the one before
    std::vector<double> along;     // metres along the curve to each
    std::vector<Point2> tangents;  // at each, of length 1: between those of its lines
    bool closed = false;           // the last point is the first

    double length() const { return along.back(); }
    int segments() const { return static_cast<int>(points.size()) - 1; }
    Point2 at(double metres_along) const;
    Box box() const;
};

// Straight lines between points. Throws bad_request, naming `name`, for what has no
// length.
Shape shape_through(std::vector<Point2> points, const std::string& name);

// A smooth curve through points: centripetal Catmull-Rom, which makes no loops and no
// cusps where points lie unevenly (Yuksel, Schaefer and Keyser 2011). A ring where the
// last is the first.
std::vector<Point2> smooth_through(const std::vector<Point2>& points, double tolerance);

struct NamedShape {
    std::string name;
    Shape shape;
};

// What the options say of one curve: one shape, or one for each path of a drawing. Throws
// bad_request.
std::vector<NamedShape> shapes_of(const Curve& curve, const Ground& ground);

}  // namespace cydonia::texture
