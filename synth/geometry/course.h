#pragma once

#include <array>
#include <vector>

#include "synth/geometry/hermite.h"
#include "synth/geometry/shape.h"

namespace cydonia::geometry {

// What a curve asks for at one of its points. Pairs are left and right of the direction
// in which the curve runs.
struct Trait {
    double height = 0.0;  // metres
    std::array<double, 2> gradient{};
    std::array<double, 2> area{};  // metres
};

// What a curve asks for along its whole length: Hermite curves between its handles,
// tabulated every half cell.
class Course {
  public:
    // Throws bad_request for handles outside the curve, for two handles at the same
    // position and for negative areas.
    Course(const Curve& curve, const std::string& name, const Shape& shape,
           const Ground& ground, const HeightAt& natural);

    Trait at(double along) const;
    double height(double along) const { return at(along).height; }
    // Adds the Hermite curve through `knots` to the heights.
    void bend(const std::vector<Knot>& knots);
    // Positions of the handles that fix the height, in metres along the curve.
    const std::vector<double>& held() const { return held_; }
    double largest_area() const { return largest_area_; }
    bool one_area() const;  // the same everywhere and on both sides

  private:
    void tabulate(const Curve& curve, const std::vector<Handle>& handles,
                  const Ground& ground);

    double length_, step_;
    bool ring_;
    std::vector<Trait> table_;
    std::vector<double> held_;
    double largest_area_ = 0.0;
};

}  // namespace cydonia::geometry
