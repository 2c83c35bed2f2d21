#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/terrain.h"
#include "synth/distance/dijkstra.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// F and C_g: the generator nodes of every feature, feature by feature.
struct Features {
    std::vector<Start> starts;
    std::vector<int> first{0};  // of each feature in `starts`, and one past the last

    int count() const { return static_cast<int>(first.size()) - 1; }
    std::span<const Start> of(int feature) const {
        return std::span(starts).subspan(first[feature],
                                         first[feature + 1] - first[feature]);
    }
};

// Rusnell 2009, section 3.3, step 2: strokes (a feature each connected piece of one
// colour), random peaks, then ridges that extend the feature they grow from (section
// 4.1). The least cost that noise gives is 0. Throws bad_request when there is no
// feature.
Features features_of(const Options& options, const Graph& graph, std::uint64_t seed);

}  // namespace cydonia::distance
