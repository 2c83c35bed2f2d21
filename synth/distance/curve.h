#pragma once

#include <string>
#include <vector>

#include "synth/distance/options.h"

namespace cydonia::distance {

struct CurvePoint {
    double x, f;
};

// The points of a curve, to be joined by straight lines: at least two, x strictly rising.
// Of a picture: the middle of the dark line in each column that has one, in pixels, f
// upward. Of a table: its lines, at most 4096; # begins a comment. `what` the curve is
// ("profile mesa") begins the messages of bad_request, which name file and line.
std::vector<CurvePoint> points_of(const Curve& curve, const std::string& what);

// The same of a cross-section: f never rises and ends below its beginning. The line of a
// picture may waver by a pixel. Throws bad_request, saying where it rises.
std::vector<CurvePoint> falling_points_of(const Curve& curve, const std::string& what);

// The points of any curve, x stretched to 0 to 1 and f to 0 to 1; a level one is 1
// throughout. Throws as points_of.
std::vector<CurvePoint> unit_points_of(const Curve& curve, const std::string& what);

}  // namespace cydonia::distance
