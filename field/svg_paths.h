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

// One run of a pen in a drawing: an outline is closed when it ends where it began.
struct SvgPath {
    std::string id;  // its own, else that of the nearest group; empty without any
    // Ids and Inkscape's labels of it and of all groups around it, innermost first.
    std::vector<std::string> names;
    bool is_called(const std::string& name) const;
    // At least two, each unlike the one before: shares of the page's width from its left
    // edge and of its height from its top.
    std::vector<Point2> points;
    // What it is filled with, its own or a group's around it, where that is one colour.
    std::optional<std::array<std::uint8_t, 3>> fill = {};
    std::size_t shape = 0;  // outlines of one element have the same number
};

// The paths and shapes of an SVG drawing in its order, with the transforms of their
// groups; curves within `tolerance` (a share of the page). What is in <defs>, what is not
// displayed, text, and files it refers to are left out. Throws bad_request for what is no
// drawing and for paths that cannot be read.
std::vector<SvgPath> svg_paths(const Source& source, double tolerance);

}  // namespace cydonia
