#pragma once

#include <string>

#include "synth/geometry/course.h"
#include "synth/geometry/shape.h"
#include "synth/texture/constraints/area.h"

namespace cydonia::texture {

// What a constraint asks for at a position on the ground.
struct Demand {
    double target = 0.0;    // h_t, metres
    double distance = 0.0;  // metres
    double area = 0.0;      // of effect there, metres
};

// A curve constraint, prepared for demand_of().
struct CurveConstraint {
    std::string name;
    geometry::Shape shape;
    geometry::Course course;
    SmoothArea area = {};
};

// What a curve asks for at p. The nearest point of the curve, which lies on line
// `segment`, decides. Beyond an end the properties of both sides are mixed by the angle
// around the end.
Demand demand_of(const geometry::Shape& shape, const geometry::Course& course,
                 int segment, const Point2& p);
inline Demand demand_of(const CurveConstraint& curve, int segment, const Point2& p) {
    Demand asked = demand_of(curve.shape, curve.course, segment, p);
    asked.area = curve.area.at(p, asked.distance, asked.area);
    return asked;
}

}  // namespace cydonia::texture
