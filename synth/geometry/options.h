#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/length.h"
#include "field/source.h"

namespace cydonia::geometry {

// A position on the terrain, from its south-west corner, east first: metres, or shares of
// the width and of the depth.
using Place2 = std::array<Length, 2>;

// A point at which the land has a given height (Gain 2015, section 5.1). Heights are in
// metres; a relative one is added to the height that the land would have there without
// constraints.
struct Point {
    std::string name;
    Place2 at;
    double height = 0.0;
    bool relative = false;
    std::array<double, 2> gradient{0.0, 0.0};  // rise over run towards east and north
    Length radius = of_width(0.05);            // of effect
};

// A widget on a curve (figure 2b). Values that a handle does not give are interpolated
// between the handles that do.
struct Handle {
    double at = 0.0;  // share of the curve's length
    std::optional<double> height = {};
    // Left and right of the direction in which the curve runs: rise over run away from
    // the curve, and the radius of effect.
    std::optional<std::array<double, 2>> gradient = {};
    std::optional<std::array<Length, 2>> area = {};
};

struct Curve {
    std::string name;
    std::vector<Place2> points =
        {};  // the curve passes through them smoothly; give either points or a drawing
    // Every path of a drawing whose page lies over the terrain, or only the path with
    // `id`.
    std::optional<Source> drawing = {};
    std::string id = {};
    double height = 0.0;  // where no handle gives one
    bool relative = false;
    std::array<double, 2> gradient{0.0, 0.0};
    std::array<Length, 2> area{of_width(0.05), of_width(0.05)};
    std::vector<Handle> handles = {};
};

}  // namespace cydonia::geometry
