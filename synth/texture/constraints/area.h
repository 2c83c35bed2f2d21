#pragma once

#include "field/field.h"
#include "synth/geometry/course.h"
#include "synth/geometry/nearest.h"

namespace cydonia::texture {

// The area of effect of a curve, without jumps (section 5.1, figure 5). On the concave
// side of a curve the nearest point jumps from one part of the curve to another, and so
// does the area of effect, which tears its boundary (where distance equals area). The
// paper extracts that isocurve and smooths it; here what it is an isocurve of is
// smoothed: the area is averaged over about a quarter of the distance to the curve, which
// nearly leaves it alone where it does not leap and never mixes the two sides of the
// curve.
class SmoothArea {
  public:
    SmoothArea() = default;  // for a curve with the same area all along
    SmoothArea(const geometry::Shape& shape, const geometry::Course& course,
               const geometry::Ground& ground);

    // The smoothed area at p, which is `distance` metres from the curve and where the
    // nearest point of the curve has the area `own`.
    double at(const Point2& p, double distance, double own) const;

  private:
    geometry::Grid grid_;  // depends on the curve and the terrain only
    Field<float> areas_;
};

}  // namespace cydonia::texture
