#pragma once

#include "field/field.h"
#include "field/progress.h"
#include "synth/distance/features.h"
#include "synth/distance/options.h"
#include "synth/distance/profile.h"

namespace cydonia::distance {

// Where a feature's own pass ends and how features meet; lengths in metres.
struct BlendOptions {
    double sea_level = 0.0;               // c_s
    double bias = 3.0;                    // b
    double sea_level_threshold = 5.0;     // epsilon_s
    double approximate_threshold = 0.05;  // p_f
    double mean_edge_weight = 2.0;        // mu_w, for profiles
};

// What the work settled, for benchmarks.
struct PassCounts {
    std::size_t approximate = 0;  // nodes of the pass with all features
    std::size_t features = 0;     // nodes of all passes with one
};

// Rusnell 2009, Algorithm 3, steps 5 to 7: heights above sea level, in metres. All starts
// cost less than sea level. `descent` is null where raw edge weights shape the land. The
// heights do not depend on the number of threads.
Field<float> blended_heights(const Graph& graph, const Features& features,
                             const Descent* descent, const BlendOptions& options,
                             Progress& progress, PassCounts* counts = nullptr);

// Bytes that blended_heights takes for a graph of this size, besides the graph.
double blend_bytes(double cells);

}  // namespace cydonia::distance
