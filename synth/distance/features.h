#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "field/terrain.h"
#include "synth/distance/dijkstra.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// F and C_g: the generator nodes of every feature, feature by feature, group by group.
struct Features {
    struct Feature {
        int group = 0;        // in Options::groups
        int profile = -1;     // in Options::profiles; -1: raw edge weights
        int other_side = -1;  // the profile beyond the stroke; -1: the same
    };
    std::vector<Start> starts;
    std::vector<int> first{0};      // of each feature in `starts`, and one past the last
    std::vector<Feature> features;  // one each
    // Where a feature has two profiles: at each start a unit vector (east, south) into
    // the side of `profile`. Empty when none has.
    std::vector<std::array<float, 2>> sides;

    int count() const { return static_cast<int>(features.size()); }
    std::span<const Start> of(int feature) const {
        return std::span(starts).subspan(first[feature],
                                         first[feature + 1] - first[feature]);
    }
};

// Rusnell 2009, section 3.3, step 2: the groups in their order, each placed, given costs,
// then extended by its ridges. `graph` has the land's own nodes; `terrain` is the land so
// far. Places and costs are the same on the ground at every resolution. Throws
// bad_request, naming the group, for what contradicts itself or finds no place, and when
// there is no feature.
Features features_of(const Options& options, const Graph& graph, const Terrain& terrain,
                     std::uint64_t seed);

}  // namespace cydonia::distance
