#pragma once

#include <string>

#include "synth/geometry/course.h"
#include "synth/geometry/shape.h"
#include "synth/texture/constraints/area.h"

namespace cydonia::texture {

// What a constraint asks of a place on the plane.
struct Asked {
    double target = 0.0;    // h_t, metres
    double distance = 0.0;  // metres
    double area = 0.0;      // of effect there, metres
};

// A curve constraint, ready to be asked.
struct Strand {
    std::string name;
    Shape shape;
    Course course;
    SmoothArea area = {};
};

// By the point of the curve that is nearest to p, which is on line `segment`. Beyond an
// end both sides' properties are mixed by the angle around it.
Asked asked_by(const Shape& shape, const Course& course, int segment, const Point2& p);
inline Asked asked_by(const Strand& strand, int segment, const Point2& p) {
    Asked asked = asked_by(strand.shape, strand.course, segment, p);
    asked.area = strand.area.at(p, asked.distance, asked.area);
    return asked;
}

}  // namespace cydonia::texture
