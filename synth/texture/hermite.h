#pragma once

#include <vector>

namespace cydonia::texture {

struct Knot {
    double at, value;
};

// Hermite interpolation between knots with the tangents of Fritsch and Butland (1984): it
// never leaves the heights of the two knots it is between, so a river has no sink and an
// area of effect is never negative that no handle asked for; Catmull-Rom tangents
// overshoot. Level before the first knot and after the last, without a bend.
class Hermite {
  public:
    // At least one knot, sorted, all apart. With a period the last runs into the first.
    explicit Hermite(std::vector<Knot> knots, double period = 0.0);

    double operator()(double at) const;

  private:
    std::vector<Knot> knots_;
    std::vector<double> tangents_;
};

}  // namespace cydonia::texture
