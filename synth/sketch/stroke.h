#pragma once

#include <string>
#include <vector>

#include "field/bezier.h"
#include "field/field.h"
#include "field/progress.h"
#include "field/svg_paths.h"
#include "synth/sketch/options.h"

namespace cydonia::sketch {

// Strokes as one line of values from their leftmost to their rightmost point. A part that
// is drawn later replaces what it retraces; gaps are bridged.
struct Line {
    double left = 0.0, right = 0.0;
    Field<float> values;  // one row
    bool folds = false;   // a stroke runs back; the part drawn last counts
};
// The outline of y over x. The strokes must have a width.
Line line_of(const std::vector<std::vector<Point2>>& strokes, int values);

// The paths of a drawing, or those with an id. Throws bad_request if there are none.
std::vector<SvgPath> strokes_of(const Source& drawing, const std::string& id,
                                const std::string& name);

// A row of heights of a silhouette in metres, from its leftmost to its rightmost point.
// Says where it folds back. Throws bad_request if nothing is drawn or it has no width.
Field<float> heights_of(const Silhouette& silhouette, int values, const std::string& name,
                        Progress& progress);

// Cuts off the loops of a way where it crosses itself, and returns their number. Of a
// closed way the longest part stays.
int cut_loops(std::vector<Point2>& way);

}  // namespace cydonia::sketch
