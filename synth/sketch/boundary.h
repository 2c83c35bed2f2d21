#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/geometry/shape.h"

namespace cydonia::sketch {

// How far a landform reaches to the left and right of a place along its shadow, metres.
using Boundary = std::function<std::array<double, 2>(double along)>;

// Figure 3: as wide as the silhouette's shoulders are long on average, with rounded ends
// as long as they are. A single peak stands on a disc, a range on a capsule. `silhouette`
// over `length` metres.
Boundary capsule(const Field<float>& silhouette, double length);

// The same boundary with rounded ends; not where a landform goes on over them.
Boundary rounded(Boundary boundary, double length, const std::array<bool, 2>& goes_on);

// As far as curves that are drawn around the shadow. Where they cross it, or leave a gap,
// between their neighbours, and says so. Throws bad_request where they leave open most
// of a side.
Boundary drawn_boundary(const texture::Shape& shadow,
                        const std::vector<texture::NamedShape>& curves, double spacing,
                        const std::string& name, Progress& progress);

}  // namespace cydonia::sketch
