#pragma once

#include <vector>

#include "field/terrain.h"
#include "synth/pareidolia/light_frame.h"

namespace cydonia::pareidolia {

// Marks a cell without a feature.
inline constexpr float kNowhere = -1e30f;

// What an image requires of the land under its sun.
struct ShadowPlan {
    const Field<std::uint8_t>* target = nullptr;
    double rise =
        0.0;           // the light's fall over one cell, metres: tan(elevation) * spacing
    LightFrame frame;  // fine enough that no start cell is missed
    std::vector<Run> runs;  // every shadow along a line of light

    int width() const { return target->width(); }
    int height() const { return target->height(); }
    double length(const Run& run) const {  // cells
        return static_cast<double>(run.past - run.first) / frame.density;
    }
    // The border between lit and dark lies half a sample before the first dark one.
    GridPoint start(const Run& run) const {
        return frame.position(run.first - 0.5, run.row);
    }
    GridPoint end(const Run& run) const {
        return frame.position(run.past - 0.5, run.row);
    }
};

ShadowPlan shadow_plan(const ShadowImage& image, double spacing);

// Eq. 5.1 and 5.4: the height in metres of the crest of each run above its end on
// `ground`.
std::vector<float> crest_heights(const ShadowPlan& plan, const Field<float>& ground);

// Step 6: the heights of the cells where shadows start; kNowhere elsewhere.
Field<float> primary_features(const ShadowPlan& plan, const std::vector<float>& crests);

// The height of `ground` in the cells where shadows end; kNowhere elsewhere.
Field<float> shadow_ends(const ShadowPlan& plan, const Field<float>& ground);

// A height below the line of light from crest to end (figure 5.3a) over each cell in
// shadow, the lower the larger `relief` (0 to 1) is. Elsewhere it is far above any land.
Field<float> shadow_ceiling(const ShadowPlan& plan, const std::vector<float>& crests,
                            const Field<float>& relief);

// Calls visit(cell, cells behind the crest) for the cells under a run, and twice for some
// of them.
template <class Visit>
void each_cell(const ShadowPlan& plan, const Run& run, const Visit& visit) {
    const GridPoint start = plan.start(run);
    for (int i = run.first; i < run.past; i += 2) {
        const Cell cell = cell_of(plan.frame.position(i, run.row));
        if (!plan.target->contains(cell.x, cell.y)) continue;
        const double behind = (cell.x - start.x) * plan.frame.along.x +
                              (cell.y - start.y) * plan.frame.along.y;
        visit(cell, behind > 0.0 ? behind : 0.0);
    }
}

}  // namespace cydonia::pareidolia
