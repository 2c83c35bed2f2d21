#pragma once

#include <string>

#include "synth/geometry/course.h"
#include "synth/geometry/shape.h"
#include "synth/texture/constraints/area.h"

namespace cydonia::texture {

// What a constraint asks of a place on the plane.
struct Demand {
    double target = 0.0;    // h_t, metres
    double distance = 0.0;  // metres
    double area = 0.0;      // of effect there, metres
};

// A curve constraint, ready to be asked.
struct CurveConstraint {
    std::string name;
    geometry::Shape shape;
    geometry::Course course;
    SmoothArea area = {};
};

// By the point of the curve that is nearest to p, which is on line `segment`. Beyond an
// end both sides' properties are mixed by the angle around it.
Demand demand_of(const geometry::Shape& shape, const geometry::Course& course,
                 int segment, const Point2& p);
inline Demand demand_of(const CurveConstraint& curve, int segment, const Point2& p) {
    Demand asked = demand_of(curve.shape, curve.course, segment, p);
    asked.area = curve.area.at(p, asked.distance, asked.area);
    return asked;
}

}  // namespace cydonia::texture
