#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "synth/distance/cost_model.h"
#include "synth/distance/features.h"
#include "synth/distance/regions.h"

namespace cydonia::distance {

// Everything that passes run over. All starts must cost less than sea level.
struct Ground {
    const Graph& graph;
    const Features& features;
    const Shapes& shapes;
    const Regions& regions;
};

// The heights at which a feature's pass ends (docs/papers.md, Rusnell 5).
struct Halting {
    float sea_level_threshold = 5.0f;     // epsilon_s, metres
    float approximate_threshold = 0.05f;  // p_f

    bool at_sea(float height) const { return !(height > sea_level_threshold); }
    bool far_below(float height, float approximate) const {
        return !(height > approximate_threshold * approximate);
    }
    bool goes_on(float height, float approximate) const {
        return !at_sea(height) && !far_below(height, approximate);
    }
};

// Rusnell 2009, eq. 3.2: the height above sea level in metres, at least 0.
inline float height_of(float cost, const Shapes& shapes) {
    return std::max(0.0f, static_cast<float>(shapes.sea_level) - cost);
}

// Rusnell 2009, Algorithm 3, steps 5 and 6: the height of the highest feature at each
// node, 0 where none reaches. In a region that is open to some groups only, the highest
// of those.
std::vector<float> approximate_heights(const Ground& ground, const Halting& halting);

// The nodes that a feature's own pass reached. Every node comes after those of its path.
struct Pass {
    std::vector<int> nodes;
    std::vector<float> heights;
    std::vector<Label> labels;  // where asked for
    std::size_t settled = 0;    // nodes that it took to find it
};

enum class Keep { kHeights, kLabels };

// Step 7a: the pass of one feature.
Pass pass_of(int feature, const Ground& ground, const Halting& halting,
             std::span<const float> approximate, LeastCost& paths,
             Keep keep = Keep::kHeights);

// The same with labels, starting from the trace of the pass over other approximate
// heights.
Pass pass_again(int feature, const Ground& ground, const Halting& halting,
                std::span<const float> approximate, const LeastCost::Trace& trace,
                LeastCost& paths);

}  // namespace cydonia::distance
