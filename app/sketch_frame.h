#pragma once

#include "app/console.h"
#include "app/request.h"

namespace cydonia {

// Writes <output folder>/sketch/<camera>.svg for each perspective camera of the scene:
// its frame by Embree as a locked layer, an empty layer to draw silhouettes in, and where
// the camera stands as metadata. Also writes sketch/plan.svg, whose page is the land seen
// from above. Throws bad_request if a file has strokes in it, unless the request says
// force.
void frame_for_sketch(const Request& request, Console& console);

}  // namespace cydonia
