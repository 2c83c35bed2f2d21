#pragma once

#include <vector>

#include "field/field.h"

namespace cydonia::genetic {

// A line along which land is steepest, found over all scales at once.
struct Edge {
    float scale = 0.0f;   // metres: how far the step is spread out, a standard deviation
    float length = 0.0f;  // metres
    float strength = 0.0f;  // the detector's response, t^(1/4) |grad L|, t in samples^2
};

// Edges by scale-space detection with automatic scale selection (Lindeberg 1998; Saunders
// 2006, section III.3.2.2): where t^(1/2) |grad L|^2 is largest over scales and along the
// slope. A diffuse step is found at its own width. Heights in metres.
std::vector<Edge> edges_of(const Field<float>& heights, double spacing);

// Mirrored beyond the sides. `deviation` in samples.
Field<float> blurred(const Field<float>& field, double deviation);

}  // namespace cydonia::genetic
