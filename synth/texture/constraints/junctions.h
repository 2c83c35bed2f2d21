#pragma once

#include <string>
#include <vector>

#include "field/progress.h"
#include "synth/texture/constraints/curve_constraint.h"

namespace cydonia::texture {

// A point constraint, prepared for asked().
struct PointConstraint {
    std::string name;
    Point2 at{};
    double height = 0.0;  // metres
    Point2 gradient{};    // rise over run towards east and north
    double radius = 0.0;  // metres

    Demand asked(const Point2& p) const {
        const Point2 v = geometry::from_to(at, p);
        return {height + geometry::dot(gradient, v), geometry::length(v), radius};
    }
};

// Gives one height to each junction, where constraints cross or touch. A curve that
// crosses itself takes the mean of its two heights. Of two constraints the earlier one
// keeps its height (points come before curves) and the later one is bent to it: smoothly,
// over twice its area of effect, at least twice the difference and at most as far as its
// next handle. Warns, once a pair, where heights differ by more than a tenth of a cell,
// and says which won. Throws bad_request where curves are one tangle.
void join(std::vector<PointConstraint>& points, std::vector<CurveConstraint>& curves,
          const geometry::Ground& ground, Progress& progress);

}  // namespace cydonia::texture
