#pragma once

#include <cstdint>
#include <vector>

#include "field/field.h"
#include "synth/distance/features.h"
#include "synth/distance/options.h"

namespace cydonia::distance {

// The regions of a stage by node of its graph. A vector is empty when no region has that
// rule.
struct Regions {
    // The index in Options::profiles of the profile that holds at each node; kFree stands
    // for each feature's own.
    static constexpr std::uint8_t kFree = 255;
    std::vector<std::uint8_t> profile_at;
    // The region that closes each node to all groups but its own, and by how much, 0
    // to 1.
    std::vector<std::uint8_t> closed_by;
    std::vector<float> closed;
    std::vector<std::uint64_t> open_to;  // of each region: a bit a group

    // The share of its weight that a feature of `group` keeps at a node.
    float admission(int node, int group) const {
        if (closed.empty() || closed[node] == 0.0f) return 1.0f;
        return open_to[closed_by[node]] >> group & 1 ? 1.0f : 1.0f - closed[node];
    }
};

// Throws bad_request for a region inside a group that encloses nothing.
Regions regions_of(const Options& options, const Graph& graph, const Features& features);

// A mask that is 1 within the closed strokes of a group and 0 on the strokes themselves.
Field<std::uint8_t> enclosed(const Graph& graph, const Features& features, int group);

}  // namespace cydonia::distance
