#pragma once

#include <vector>

#include "synth/pareidolia/region_tree.h"
#include "synth/pareidolia/shadow_plan.h"

namespace cydonia::pareidolia {

// The lines of light over the shadows: the heights of crests, and the ground of the lit
// holes that rise above the shadow line.
struct ShadowLines {
    std::vector<float> crests;  // of each run of the plan, metres
    Field<float> holes;  // ground of each cell of a hole, metres; kNowhere elsewhere
};

// Rusnell 2009, section 5.3.1: every run has a crest of its own (eq. 5.4), and there are
// no holes.
ShadowLines lines_of_runs(const ShadowPlan& plan, const Field<float>& ground);

// Section 5.3.2, level by level of the image's homotopic tree: a shadow with its holes
// filled has one crest, whose height eq. 5.4 gives for the whole. Where light enters a
// hole, the hole stands `above` metres over the shadow line of that crest, and islands of
// shadow in it have crests again.
//
// There is one departure. In the thesis holes follow the shadow line to their ends, so
// that light only grazes them. Here their ground falls by `fall` of the light's own
// slope, and the crest in front is lower by the height that the line gains along the
// hole. With `fall` = 1 holes are as in the thesis; with 0 they are level, and crests are
// as in section 5.3.1.
ShadowLines lines_of_regions(const ShadowPlan& plan, const RegionTree& tree,
                             const Field<float>& ground, double above, double fall);

}  // namespace cydonia::pareidolia
