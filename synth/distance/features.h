#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "field/terrain.h"
#include "synth/distance/dijkstra.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// F and C_g: the generator nodes of all features, ordered by group and by feature.
struct Features {
    struct Feature {
        int group = 0;        // in Options::groups
        int profile = -1;     // in Options::profiles; -1: raw edge weights
        int other_side = -1;  // the profile beyond the stroke; -1: the same
    };
    std::vector<Start> starts;
    std::vector<int> first{0};      // of each feature in `starts`, and one past the last
    std::vector<Feature> features;  // one each
    // For features with two profiles: a unit vector (east, south) at each start that
    // points into the side of `profile`. Empty when no feature has two.
    std::vector<std::array<float, 2>> sides;

    int count() const { return static_cast<int>(features.size()); }
    std::span<const Start> of(int feature) const {
        return std::span(starts).subspan(first[feature],
                                         first[feature + 1] - first[feature]);
    }
};

// Rusnell 2009, section 3.3, step 2: places the groups in their order, gives them costs
// and extends them by their ridges. `graph` has the land's own nodes, and `terrain` is
// the land so far. Places and costs are the same on the ground at every resolution.
// Throws bad_request, naming the group, for options that contradict themselves or find no
// place, and when there is no feature.
Features features_of(const Options& options, const Graph& graph, const Terrain& terrain,
                     std::uint64_t seed);

}  // namespace cydonia::distance
