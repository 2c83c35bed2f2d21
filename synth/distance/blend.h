#pragma once

#include <cstddef>
#include <vector>

#include "field/field.h"
#include "field/progress.h"
#include "synth/distance/pass_memory.h"
#include "synth/distance/passes.h"

namespace cydonia::distance {

// How features are blended.
struct BlendOptions {
    double bias = 3.0;      // b, where there is no map
    Field<float> bias_map;  // b of each sample; empty: everywhere the same
};

// How many passes were made.
struct PassCounts {
    std::size_t features = 0;  // of all passes with one feature
    std::size_t recalled = 0;  // of them those that were known from an earlier run
};

// Objects that watch the passes; either may be null. The caller owns them.
struct Observers {
    PassMemory* memory = nullptr;
    class Explainer* explainer = nullptr;
};

// Rusnell 2009, Algorithm 3, step 7: computes the heights above sea level, in metres,
// from the approximate ones. They depend neither on the number of threads nor on what is
// remembered.
Field<float> blended_heights(const Ground& ground, const Halting& halting,
                             const BlendOptions& options,
                             const std::vector<float>& approximate, Progress& progress,
                             const Observers& observers = {},
                             PassCounts* counts = nullptr);

// Copies values by node into a field of the graph's samples.
Field<float> by_sample(const Graph& graph, const std::vector<float>& values);

// The memory in bytes that blended_heights() takes besides a graph of this size.
double blend_bytes(double cells);

}  // namespace cydonia::distance
