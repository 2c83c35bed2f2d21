#pragma once

#include <vector>

#include "synth/texture/constraints/junctions.h"

namespace cydonia::texture {

// Where two constraints, or two parts of one curve, come together: constraints count from
// 0, points first.
struct Crossing {
    int first, second;  // first <= second
    double along[2];    // metres along either; 0 for a point
    Point2 at;
};

// All crossings of curves, and every end of a curve and every point within half a cell of
// another constraint: one for all that is within a cell, sorted by second, along it, then
// first. Throws bad_request above kMostCrossings.
inline constexpr std::size_t kMostCrossings = 20'000;
std::vector<Crossing> crossings_of(const std::vector<PointConstraint>& points,
                                   const std::vector<CurveConstraint>& curves,
                                   double cell);

}  // namespace cydonia::texture
