#pragma once

#include <vector>

namespace cydonia::texture {

struct Knot {
    double at, value;
};

// Hermite interpolation between knots with the tangents of Fritsch and Butland (1984): it
// never leaves the heights of the two knots it is between, so a river has no sink and an
// area of effect is never negative that no handle asked for; Catmull-Rom tangents
// overshoot. Level before the first knot and after the last, without a bend there; a knot
// at an end of the whole has nothing beyond it, and the slope of what is beside it.
class Hermite {
  public:
    // At least one knot, sorted, all apart, from 0 to `length`. On a ring the last runs
    // into the first.
    Hermite(std::vector<Knot> knots, double length, bool ring);

    double operator()(double at) const;

  private:
    std::vector<Knot> knots_;
    std::vector<double> tangents_;
};

}  // namespace cydonia::texture
