#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/length.h"
#include "field/source.h"

namespace cydonia::texture {

// Where something is on the terrain, from its south-west corner: metres, or shares of the
// width (first) and of the depth (second).
using Place2 = std::array<Length, 2>;

// Section 5.1. Heights in metres; relative ones are added to what the land would be there
// without constraints.
struct Point {
    std::string name;
    Place2 at;
    double height = 0.0;
    bool relative = false;
    std::array<double, 2> gradient{0.0, 0.0};  // rise over run towards east and north
    Length radius = of_width(0.05);            // of effect
};

// A widget on a curve (figure 2b): what is not given here is interpolated between the
// others.
struct Handle {
    double at = 0.0;  // share of the curve's length
    std::optional<double> height = {};
    // Left and right of the way the curve runs: rise over run away from it, and radius.
    std::optional<std::array<double, 2>> gradient = {};
    std::optional<std::array<Length, 2>> area = {};
};

struct Curve {
    std::string name;
    std::vector<Place2> points =
        {};  // passed through smoothly; one of points and drawing
    // Every path of a drawing whose page lies over the terrain, or the one with `id`.
    std::optional<Source> drawing = {};
    std::string id = {};
    double height = 0.0;  // where no handle says otherwise
    bool relative = false;
    std::array<double, 2> gradient{0.0, 0.0};
    std::array<Length, 2> area{of_width(0.05), of_width(0.05)};
    std::vector<Handle> handles = {};
};

}  // namespace cydonia::texture
