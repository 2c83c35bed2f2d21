#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "field/bezier.h"
#include "field/source.h"

namespace cydonia {

// One stroke of the pen in a drawing. It is closed when it ends where it began.
struct SvgPath {
    std::string id;  // its own, else that of the nearest group; empty without any
    // The ids and Inkscape labels of the element and of all groups around it, innermost
    // first.
    std::vector<std::string> names;
    bool is_called(const std::string& name) const;
    // At least two points, each different from the one before: shares of the page's width
    // from its left edge and of its height from its top.
    std::vector<Point2> points;
    // The fill of the element or of the nearest group that has one, where that is a
    // single colour.
    std::optional<std::array<std::uint8_t, 3>> fill = {};
    std::size_t shape = 0;  // outlines of one element have the same number
};

// The paths and shapes of an SVG drawing in its order, with the transforms of their
// groups applied. Curves become lines that stay within `tolerance`, a share of the page.
// The contents of <defs>, hidden elements, text, and other files are left out. Throws
// bad_request for what is no drawing and for paths that cannot be read.
std::vector<SvgPath> svg_paths(const Source& source, double tolerance);

}  // namespace cydonia
