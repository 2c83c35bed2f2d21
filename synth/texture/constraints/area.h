#pragma once

#include "field/field.h"
#include "synth/geometry/course.h"
#include "synth/geometry/nearest.h"

namespace cydonia::texture {

// The area of effect of a curve without jumps (section 5.1, figure 5). On the concave
// side of a curve the nearest point leaps from one part of it to another, and the area
// of effect with it, so that the boundary (where distance equals area) is torn. The paper
// extracts that isocurve and smooths it; here what it is an isocurve of is smoothed: the
// area is averaged over about a quarter of the distance to the curve, which nearly leaves
// it alone where it does not leap and never mixes the two sides of the curve.
class SmoothArea {
  public:
    SmoothArea() = default;  // of a curve that has one area all along: nothing to smooth
    SmoothArea(const Shape& shape, const Course& course, const Ground& ground);

    // At p, `distance` metres from the curve, where the nearest point says `own`.
    double at(const Point2& p, double distance, double own) const;

  private:
    Grid grid_;  // fixed by the curve and the terrain
    Field<float> areas_;
};

}  // namespace cydonia::texture
