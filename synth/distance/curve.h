#pragma once

#include <string>
#include <vector>

#include "synth/distance/options.h"

namespace cydonia::distance {

struct CurvePoint {
    double x, f;
};

// The points of a curve, which straight lines join: at least two, with strictly rising x.
// A picture has a point in each column with a dark line, in its middle, in pixels with f
// upward. A table has a point in each line, at most 4096; # begins a comment. Throws
// bad_request with messages that begin with `what` ("profile mesa") and name the file and
// line.
std::vector<CurvePoint> points_of(const Curve& curve, const std::string& what);

// The same for a cross-section, whose f never rises and ends below its beginning. The
// line of a picture may waver by a pixel. Throws bad_request that says where it rises.
std::vector<CurvePoint> falling_points_of(const Curve& curve, const std::string& what);

// The points of any curve with x and f stretched to 0 to 1; a level curve is 1
// throughout. Throws as points_of() does.
std::vector<CurvePoint> unit_points_of(const Curve& curve, const std::string& what);

}  // namespace cydonia::distance
