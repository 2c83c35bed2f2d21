#pragma once

#include <vector>

#include "synth/texture/constraints/junctions.h"

namespace cydonia::texture {

// Where two constraints, or two parts of one curve, cross or touch. Constraints are
// numbered from 0, points first.
struct Crossing {
    int first, second;  // first <= second
    double along[2];    // metres along each of the two; 0 for a point
    Point2 at;
};

// All crossings of curves, and all ends of curves and points within half a cell of
// another constraint. Those within a cell of each other count as one. Sorted by `second`,
// by the position along it, then by `first`. Throws bad_request above kMostCrossings.
inline constexpr std::size_t kMostCrossings = 20'000;
std::vector<Crossing> crossings_of(const std::vector<PointConstraint>& points,
                                   const std::vector<CurveConstraint>& curves,
                                   double cell);

}  // namespace cydonia::texture
