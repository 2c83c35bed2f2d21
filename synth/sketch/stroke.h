#pragma once

#include <string>
#include <vector>

#include "field/bezier.h"
#include "field/field.h"
#include "field/progress.h"
#include "field/svg_paths.h"
#include "synth/sketch/options.h"

namespace cydonia::sketch {

// Strokes as one line of values, from their leftmost point to their rightmost: what is
// drawn later replaces what it retraces, gaps are bridged.
struct Line {
    double left = 0.0, right = 0.0;
    Field<float> values;  // a row
    bool folds = false;   // a stroke goes back on itself; what is drawn last counts
};
// Values are y over x. Needs a width.
Line line_of(const std::vector<std::vector<Point2>>& strokes, int values);

// The paths of a drawing, or those with an id. Throws bad_request where there are none.
std::vector<SvgPath> strokes_of(const Source& drawing, const std::string& id,
                                const std::string& name);

// So many heights of a silhouette, from its leftmost point to its rightmost: a row,
// metres. Says where it folds back. Throws bad_request: nothing drawn, or no width.
Field<float> heights_of(const Silhouette& silhouette, int values, const std::string& name,
                        Progress& progress);

// Cuts off the loops of a way, where it crosses itself; gives how many. Of a closed one
// its longest part stays.
int cut_loops(std::vector<Point2>& way);

}  // namespace cydonia::sketch
