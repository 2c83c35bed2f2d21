#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/distance/features.h"
#include "synth/distance/growth.h"
#include "synth/distance/regions.h"

namespace cydonia::distance {

// Where a feature's own pass ends and how features meet; lengths in metres.
struct BlendOptions {
    double bias = 3.0;                    // b, where there is no map
    Field<float> bias_map;                // b of each sample; empty: everywhere the same
    double sea_level_threshold = 5.0;     // epsilon_s
    double approximate_threshold = 0.05;  // p_f
};

// Everything that passes run over. All starts cost less than sea level.
struct Ground {
    const Graph& graph;
    const Features& features;
    const Shapes& shapes;
    const Regions& regions;
};

// What the work settled, for benchmarks.
struct PassCounts {
    std::size_t approximate = 0;  // nodes of the pass with all features
    std::size_t features = 0;     // nodes of all passes with one
};

// Rusnell 2009, Algorithm 3, steps 5 and 6: costs by node, above sea level where no
// feature comes.
std::vector<float> approximate_costs(const Ground& ground, const BlendOptions& options);

// Algorithm 3, step 7: heights above sea level, in metres, from the approximate costs.
// They do not depend on the number of threads.
Field<float> blended_heights(const Ground& ground, const BlendOptions& options,
                             const std::vector<float>& approximate_costs,
                             Progress& progress, PassCounts* counts = nullptr);

// Step 6 alone: the highest feature of every place, with seams between them.
Field<float> approximate_heights(const Ground& ground,
                                 const std::vector<float>& approximate_costs);

// Bytes that blended_heights takes for a graph of this size, besides the graph.
double blend_bytes(double cells);

}  // namespace cydonia::distance
