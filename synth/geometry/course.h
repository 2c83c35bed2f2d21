#pragma once

#include <array>
#include <vector>

#include "synth/geometry/hermite.h"
#include "synth/geometry/shape.h"

namespace cydonia::texture {

// What a curve asks for at one place of it: left and right of the way it runs.
struct Trait {
    double height = 0.0;  // metres
    std::array<double, 2> gradient{};
    std::array<double, 2> area{};  // metres
};

// What a curve asks for all along it: Hermite curves between its handles, tabulated every
// half cell.
class Course {
  public:
    // Throws bad_request for handles that make no sense.
    Course(const Curve& curve, const std::string& name, const Shape& shape,
           const Ground& ground, const HeightAt& natural);

    Trait at(double along) const;
    double height(double along) const { return at(along).height; }
    // Adds the Hermite curve between these to the heights.
    void bend(const std::vector<Knot>& knots);
    // Where handles hold the height, metres along.
    const std::vector<double>& held() const { return held_; }
    double largest_area() const { return largest_area_; }
    bool one_area() const;  // everywhere and on both sides

  private:
    void tabulate(const Curve& curve, const std::vector<Handle>& handles,
                  const Ground& ground);

    double length_, step_;
    bool ring_;
    std::vector<Trait> table_;
    std::vector<double> held_;
    double largest_area_ = 0.0;
};

}  // namespace cydonia::texture
