#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/geometry/shape.h"

namespace cydonia::sketch {

// How far a landform reaches to the left and right of a position along its shadow,
// metres.
using Boundary = std::function<std::array<double, 2>(double along)>;

// The default boundary (figure 3): as wide as the silhouette's shoulders are long on
// average, with rounded ends of the same length. A single peak stands on a disc, a range
// on a capsule. The silhouette is `length` metres long.
Boundary capsule(const Field<float>& silhouette, double length);

// The boundary with rounded ends, except where the landform continues beyond an end.
Boundary rounded(Boundary boundary, double length, const std::array<bool, 2>& goes_on);

// The boundary given by curves that are drawn around the shadow. Where they cross the
// shadow or leave a gap, it is interpolated, and a note says so. Throws bad_request where
// curves leave most of a side open.
Boundary drawn_boundary(const geometry::Shape& shadow,
                        const std::vector<geometry::NamedShape>& curves, double spacing,
                        const std::string& name, Progress& progress);

}  // namespace cydonia::sketch
