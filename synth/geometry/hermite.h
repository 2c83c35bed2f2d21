#pragma once

#include <vector>

namespace cydonia::geometry {

struct Knot {
    double at, value;
};

// Hermite interpolation between knots with the tangents of Fritsch and Butland (1984).
// Between two knots it never leaves the range of their values, so a river gets no sink
// and an area of effect never becomes negative; Catmull-Rom tangents would overshoot. The
// curve is level before the first knot and after the last, without a bend there. A knot
// at an end of the whole length has nothing beyond it, and takes the slope of what is
// beside it.
class Hermite {
  public:
    // `knots` is not empty, sorted, without equal positions, from 0 to `length`. On a
    // ring the last runs into the first.
    Hermite(std::vector<Knot> knots, double length, bool ring);

    double operator()(double at) const;

  private:
    std::vector<Knot> knots_;
    std::vector<double> tangents_;
};

}  // namespace cydonia::geometry
